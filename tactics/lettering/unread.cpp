// SPDX-License-Identifier: Apache-2.0
// Print that no reader made out.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/skeleton.h"
#include "tactics/lettering/read_line.h"

namespace tactics {

namespace {

// Settings. Of the height of known print; of the longer side; of what a band as long and as wide has in ink.
constexpr double kLeastOfKnown = 0.7, kMostOfKnown = 1.4, kNarrow = 0.3, kBandLike = 0.8;
constexpr double kSurelyRead = 80;             // of 100, of three letters: rows of marks are read with less
constexpr int kLeastMark = 9, kMostMark = 60;  // pixels
constexpr std::size_t kFewUnread = 8;          // where no print is known

struct MarkShape {
    double side = 0, across = 0, share = 0, band = 0, slant = 0;
    Point middle;  // of its ink, in shares of its box
};

// From the moments of its ink. A bar, whichever way it lies, and a disc fill the bar with their moments.
MarkShape mark_shape(const InkPiece& piece) {
    double area = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (const InkRun& run : piece.runs)
        for (int column = run.left; column < run.right; ++column) {
            const double u = column - piece.box.left, v = run.y - piece.box.top;
            area += 1, x += u, y += v, xx += u * u, yy += v * v, xy += u * v;
        }
    MarkShape shape;
    if (area == 0) return shape;
    shape.side = std::max(piece.box.width(), piece.box.height());
    shape.across = std::min(piece.box.width(), piece.box.height());
    shape.share = area / (shape.side * shape.across);
    shape.middle = {(x / area + 0.5) / piece.box.width(), (y / area + 0.5) / piece.box.height()};
    const double a = xx / area - x * x / (area * area) + 1.0 / 12, b = yy / area - y * y / (area * area) + 1.0 / 12,
                 c = xy / area - x * y / (area * area);
    shape.slant = std::abs(c) / std::sqrt(std::max(1e-9, a * b));
    shape.band = area / (12 * std::sqrt(std::max(1e-9, a * b - c * c)));
    return shape;
}

bool is_letter_like(const MarkShape& shape) {
    return shape.side >= kLeastMark && shape.side <= kMostMark && shape.across >= kNarrow * shape.side && shape.band < kBandLike;
}

bool is_doubtful(const ReadLine& line) { return !line.words.sure && !line.tell; }

using KnownPrint = std::vector<const LetteringLine*>;

KnownPrint known_print(const std::vector<ReadLine>& lines) {
    KnownPrint known;
    for (const bool likely : {false, true}) {
        if (!known.empty()) break;
        for (const ReadLine& one : lines)
            if (likely ? one.likely : !is_doubtful(one)) known.push_back(&one.line);
    }
    return known;
}

bool as_large_as_print(const MarkShape& shape, const KnownPrint& known) {
    return std::any_of(known.begin(), known.end(), [&](const LetteringLine* other) {
        const double height = other->letter_height;
        return is_words(*other) && shape.side >= kLeastOfKnown * height && shape.side <= kMostOfKnown * height;
    });
}

bool has_room_around(const Image& grey, const LetteringLine& line) {
    const int room = std::max(2, line.letter_height / 6);
    const auto is_ink = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < grey.width && y < grey.height && (grey.row(y)[x] < line.level) != line.light;
    };
    for (int x = line.box.left - room; x < line.box.right + room; ++x)
        if (is_ink(x, line.box.top - room) || is_ink(x, line.box.bottom - 1 + room)) return false;
    for (int y = line.box.top - room; y < line.box.bottom + room; ++y)
        if (is_ink(line.box.left - room, y) || is_ink(line.box.right - 1 + room, y)) return false;
    return true;
}

// A scan is not quite level. By chance things in a plot stand in a row with some print; figures of an axis stand near others of
// it, or right beside one.
bool in_line_with_print(const LetteringLine& line, const KnownPrint& known) {
    constexpr double kNear = 0.3;                // of its size
    constexpr double kBeside = 4, kNotFar = 12;  // heights of letters
    const PixelBox& box = line.box;
    const int size = std::max(box.width(), box.height());
    int count = 0;
    bool beside = false, not_far = false;
    for (const LetteringLine* other : known) {
        if (other == &line) continue;
        const PixelBox& b = other->box;
        const double height = other->letter_height;
        const double near = kNear * std::min<double>(size, kMostOfKnown * height);
        const bool row = std::abs(box.bottom - b.bottom) <= near;
        const bool column = std::abs(box.right - b.right) <= near || std::abs(box.left - b.left) <= near ||
                            std::abs(box.left + box.right - b.left - b.right) <= 2 * near;
        if (!row && !column) continue;
        ++count;
        const int gap = row ? std::max(box.left, b.left) - std::min(box.right, b.right)
                            : std::max(box.top, b.top) - std::min(box.bottom, b.bottom);
        beside = beside || gap <= kBeside * height;
        not_far = not_far || gap <= kNotFar * height;
    }
    return beside || (count > 1 && not_far);
}

Point middle_of(const PixelBox& box) { return {0.5 * (box.left + box.right), 0.5 * (box.top + box.bottom)}; }

double gap_between(const PixelBox& a, const PixelBox& b) {
    return std::hypot(std::max({0, a.left - b.right, b.left - a.right}), std::max({0, a.top - b.bottom, b.top - a.bottom}));
}

// Figures of an axis of which none was read: at least four of one height, in even steps along a row or column that need not be
// quite level.
bool is_on_scale(std::size_t which, const std::vector<ReadLine>& lines) {
    constexpr double kOneHeight = 0.2, kLevel = 0.05, kOff = 0.3;  // of the height; of the step; of the height
    constexpr int kLeast = 4;
    const double height = lines[which].line.letter_height;
    const auto is_alike = [&](const ReadLine& one) { return std::abs(one.line.letter_height - height) <= kOneHeight * height; };
    const auto is_at = [&](const Point& at) {
        return std::any_of(lines.begin(), lines.end(), [&](const ReadLine& one) {
            return is_alike(one) && distance(middle_of(one.line.box), at) <= kOff * height;
        });
    };
    const Point from = middle_of(lines[which].line.box);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Point to = middle_of(lines[i].line.box);
        const double x = to.x - from.x, y = to.y - from.y, step = std::hypot(x, y);
        if (i == which || !is_alike(lines[i]) || std::min(std::abs(x), std::abs(y)) > kLevel * step || step < 2 * height)
            continue;
        int count = 2;
        for (int side : {-1, 1})
            for (int k = side < 0 ? -1 : 2; count < kLeast && is_at({from.x + k * x, from.y + k * y}); k += side) ++count;
        if (count >= kLeast) return true;
    }
    return false;
}

// Figures are as large as each other, too, but their ink lies otherwise.
bool same_mark(const MarkShape& a, const MarkShape& b) {
    return std::abs(a.side - b.side) <= 1 && std::abs(a.across - b.across) <= 1 && std::abs(a.share - b.share) <= 0.05 &&
           std::abs(a.band - b.band) <= 0.05 && distance(a.middle, b.middle) <= 0.03;
}

bool same_size(const MarkShape& a, const MarkShape& b) {
    constexpr double kSame = 0.12;
    return std::abs(a.side - b.side) <= kSame * b.side && std::abs(a.across - b.across) <= kSame * b.across;
}

// A dash of a curve where it bends, from end to end hardly longer than it is large. Letters turn more often, or branch.
bool is_bent_band(const InkPiece& piece) {
    constexpr double kBent = 1.35;
    InkMap map(piece.box.width() + 2, piece.box.height() + 2);
    for (const InkRun& run : piece.runs)
        for (int x = run.left; x < run.right; ++x) map.row(run.y - piece.box.top + 1)[x - piece.box.left + 1] = 1;
    const Skeleton middle = thin(std::move(map));
    double left = 1e9, top = 1e9, right = 0, bottom = 0;
    for (const std::uint32_t pixel : middle.pixels) {
        const double x = middle.x_of(pixel), y = middle.y_of(pixel);
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    }
    return static_cast<double>(middle.pixels.size()) <= kBent * std::hypot(right - left + 1, bottom - top + 1);
}

struct Piece {
    const InkPiece* ink = nullptr;
    MarkShape shape;
    std::size_t line = 0;
    bool alone = false;  // in its line
};

// What of the doubtful lines is drawn: marks of a plot and dashes.
class DrawnThings {
public:
    DrawnThings(const std::vector<ReadLine>& lines, const KnownPrint& known) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            in_line_.push_back(in_line_with_print(lines[i].line, known) || is_on_scale(i, lines));
            if (!is_doubtful(lines[i])) continue;
            for (const InkPiece& piece : lines[i].line.letters)
                pieces_.push_back({&piece, mark_shape(piece), i, !is_words(lines[i].line)});
        }
    }

    // Nothing in it can only be a letter. A word has letters of many shapes.
    bool has(std::size_t line) const {
        constexpr std::size_t kShapesOfWords = 4;
        std::vector<const MarkShape*> unlike;
        bool drawn = true, upright = true;
        for (const Piece& piece : pieces_) {
            if (piece.line != line) continue;
            upright = upright && (is_letter_like(piece.shape) || is_upright_bar(piece));
            if (!is_letter_like(piece.shape)) continue;
            drawn = drawn && is_drawn(piece);
            if (std::none_of(unlike.begin(), unlike.end(), [&](const MarkShape* one) { return same_mark(*one, piece.shape); }))
                unlike.push_back(&piece.shape);
        }
        return unlike.empty() ? !upright || !in_line_[line] : drawn && unlike.size() < kShapesOfWords;
    }

    // A letter of each group of letters that follow each other on a slope or a curve, so that they make no line.
    std::vector<std::size_t> sloping(const KnownPrint& known) const {
        constexpr double kGap = 0.5;  // of the larger one
        std::vector<std::size_t> found;
        std::vector<bool> taken(pieces_.size(), false);
        const auto may_follow = [&](std::size_t i) {
            return !taken[i] && as_large_as_print(pieces_[i].shape, known) && pieces_[i].shape.across > 2 &&
                   !is_repeated(pieces_[i]);
        };
        for (std::size_t first = 0; first < pieces_.size(); ++first) {
            if (!may_follow(first)) continue;
            std::vector<std::size_t> group{first};
            taken[first] = true;
            for (std::size_t at = 0; at < group.size(); ++at)
                for (std::size_t i = 0; i < pieces_.size(); ++i) {
                    const Piece &one = pieces_[group[at]], &other = pieces_[i];
                    if (gap_between(one.ink->box, other.ink->box) > kGap * std::max(one.shape.side, other.shape.side)) continue;
                    if (!may_follow(i)) continue;
                    taken[i] = true;
                    group.push_back(i);
                }
            if (const auto letter = letter_of(group)) found.push_back(*letter);
        }
        return found;
    }

private:
    bool is_repeated(const Piece& piece) const {
        return are_several([&](const Piece& other) { return same_mark(piece.shape, other.shape); });
    }

    // The line of its middle letter, if that is a word: of at least four pieces at least two can only be letters.
    std::optional<std::size_t> letter_of(const std::vector<std::size_t>& group) const {
        constexpr std::size_t kLeast = 4, kLetters = 2;
        std::vector<std::size_t> letters;
        for (const std::size_t i : group)
            if (is_letter_like(pieces_[i].shape) && !is_bent_band(*pieces_[i].ink)) letters.push_back(i);
        if (group.size() < kLeast || letters.size() < kLetters) return std::nullopt;
        return pieces_[letters[letters.size() / 2]].line;
    }

    static constexpr double kBesideDash = 0.8;  // of the mark

    // No dash.
    static bool is_mark(const MarkShape& shape) {
        constexpr double kBroad = 0.6, kSlant = 0.6;
        return is_letter_like(shape) ||
               (shape.side >= kLeastMark && shape.across >= kBroad * shape.side && shape.slant <= kSlant);
    }

    static bool is_upright_bar(const Piece& piece) {
        constexpr double kFull = 0.8;
        return piece.ink->box.height() > 2 * piece.ink->box.width() && piece.shape.share >= kFull;
    }

    bool is_drawn(const Piece& piece) const {
        if (is_bent_band(*piece.ink) && !in_line_[piece.line]) return true;
        if (is_repeated(piece)) return true;
        if (!in_line_[piece.line] && (is_among_marks(piece.shape) || is_like_one_on_dashes(piece))) return true;
        // Marks of several kinds are of about one size, about as wide as high, and the same on both sides.
        constexpr double kSquare = 0.75, kOneSize = 0.75;
        const auto is_even = [](const Piece& one) {
            return one.shape.across >= kSquare * one.shape.side && std::abs(one.shape.middle.x - 0.5) <= 0.02;
        };
        return is_even(piece) && are_several([&](const Piece& other) {
                   return is_even(other) &&
                          std::min(piece.shape.side, other.shape.side) >= kOneSize * std::max(piece.shape.side, other.shape.side);
               });
    }

    // A plot that has marks of that size, or marks that cover each other.
    bool is_among_marks(const MarkShape& shape) const {
        constexpr double kLeast = 1.15, kMost = 2.5;
        return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& mark) {
            const double side = shape.side / mark.shape.side, across = shape.across / mark.shape.across;
            const bool two = side >= kLeast && across >= kLeast && side <= kMost;
            return mark.alone && is_mark(mark.shape) && (two || same_size(shape, mark.shape)) &&
                   are_several([&](const Piece& other) { return other.alone && same_mark(mark.shape, other.shape); });
        });
    }

    bool is_like_one_on_dashes(const Piece& piece) const {
        return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& other) {
            return same_size(piece.shape, other.shape) && is_letter_like(other.shape) && is_on_dashes(other);
        });
    }

    // A mark of a dashed curve, with the nearest dash of it on each side.
    bool is_on_dashes(const Piece& piece) const {
        if (!piece.alone) return false;
        const PixelBox& box = piece.ink->box;
        const Point middle = middle_of(box);
        std::vector<Point> ways;
        for (const Piece& other : pieces_) {
            if (&other == &piece || !other.alone || gap_between(box, other.ink->box) > kBesideDash * piece.shape.side) continue;
            if (is_letter_like(other.shape)) continue;
            const Point to = middle_of(other.ink->box);
            const double length = distance(middle, to);
            if (length > 0) ways.push_back({(to.x - middle.x) / length, (to.y - middle.y) / length});
        }
        for (const Point& a : ways)
            for (const Point& b : ways)
                if (a.x * b.x + a.y * b.y < -0.8) return true;
        return false;
    }

    // Three or more, and not most of them in line with print, as figures of an axis are.
    template <typename Like>
    bool are_several(Like is_like) const {
        int count = 0, in_line = 0;
        for (const Piece& other : pieces_) {
            if (!is_like(other)) continue;
            ++count;
            in_line += in_line_[other.line] ? 1 : 0;
        }
        return count > 2 && 2 * in_line <= count;
    }

    std::vector<bool> in_line_;
    std::vector<Piece> pieces_;
};

// Most of its letters are no bars, and are as large as print that is known.
bool has_letters(const ReadLine& one, const KnownPrint& known, bool any_known) {
    std::size_t letters = 0;
    for (const InkPiece& piece : one.line.letters) {
        const MarkShape shape = mark_shape(piece);
        letters += is_letter_like(shape) && (!any_known || as_large_as_print(shape, known)) ? 1 : 0;
    }
    return letters > 0 && 2 * letters >= one.line.letters.size() && one.line.marks.size() <= one.line.letters.size();
}

}  // namespace

std::vector<bool> unread_print(const Image& grey, const std::vector<ReadLine>& lines) {
    const KnownPrint known = known_print(lines);
    const bool any_known = std::any_of(known.begin(), known.end(), [](const LetteringLine* one) { return is_words(*one); });
    const DrawnThings drawn(lines, known);
    std::vector<bool> unread(lines.size(), false);
    std::size_t count = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const ReadLine& one = lines[i];
        if (one.likely && one.words.sureness >= kSurelyRead && one.line.letters.size() > 2) {
            unread[i] = true;
            continue;
        }
        if (!is_doubtful(one) || drawn.has(i) || one.line.marks.size() > 2 * one.line.letters.size() + 1) continue;
        if (!one.likely) {
            if (!has_letters(one, known, any_known) || (!any_known && one.line.light) || !has_room_around(grey, one.line))
                continue;
            ++count;
        }
        unread[i] = true;
    }
    for (const std::size_t line : drawn.sloping(known)) unread[line] = true;
    if (!any_known && count > kFewUnread)
        for (std::size_t i = 0; i < lines.size(); ++i) unread[i] = unread[i] && lines[i].likely;
    return unread;
}

}  // namespace tactics
