// SPDX-License-Identifier: Apache-2.0
// Letters that touch a line which is drawn, freed of it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "tactics/lettering/beyond_end.h"
#include "tactics/lettering/long_strokes.h"
#include "tactics/lettering/read_line.h"

namespace tactics {

namespace {

// Of the height of letters. Settings: what reaches so far straight on is no stroke of a letter; farther off than that stands no
// letter of the same line; what hangs or stands out of its letters.
constexpr double kLongStroke = 2.2, kFarthest = 3, kGapBeside = 0.9, kOutOfLine = 0.6;
constexpr double kMark = 0.6;       // what is lower is a mark
constexpr double kGapOfSign = 0.4;  // up to a sign of degrees, and above the figures before it
constexpr int kSpeckle = 3;         // pixels wide and high together; stairs of a stroke
constexpr double kAsHigh = 0.35;    // heights of two lines that are one differ by no more: small letters stand beside capitals

// What is drawn beside a line of print.
class Beside {
public:
    Beside(const Image& grey, const LetteringLine& line, const std::vector<LetteringLine>& all) : line_(line) {
        const int along = static_cast<int>(kFarthest * line.letter_height);
        const int across = static_cast<int>(kOutOfLine * line.letter_height) + 3;
        const int least = static_cast<int>(std::ceil(kLongStroke * line.letter_height));
        const PixelBox& box = line.box;
        const PixelBox whole{0, 0, grey.width, grey.height};
        window_ = within(whole, {box.left - along, box.top - across, box.right + along, box.bottom + across});
        seen_ = within(whole, {window_.left - least, window_.top - least, window_.right + least, window_.bottom + least});
        drawn_ = make_image(seen_.width(), seen_.height(), 1, 0, 0);
        for (int y = seen_.top; y < seen_.bottom; ++y)
            for (int x = seen_.left; x < seen_.right; ++x)
                if (is_ink(grey, line, x, y)) drawn_.row(y - seen_.top)[x - seen_.left] = 1;
        for (const LetteringLine& one : all)
            if (overlap(one.box, seen_))
                for (const auto* pieces : {&one.letters, &one.marks, &one.raised})
                    for (const InkPiece& piece : *pieces) clear(piece);
        const PixelBox inner{window_.left - seen_.left, window_.top - seen_.top, window_.right - seen_.left,
                             window_.bottom - seen_.top};
        long_ = long_strokes(drawn_, inner, least);
    }

    // Ink without the long strokes, and without what reaches out of the window.
    std::vector<InkPiece> freed() const {
        Image left = make_image(window_.width(), window_.height(), 1, 0, 255);
        for (int y = window_.top; y < window_.bottom; ++y)
            for (int x = window_.left; x < window_.right; ++x)
                if (is_drawn(x, y) && long_.beside.row(y - window_.top)[x - window_.left] == 0)
                    left.row(y - window_.top)[x - window_.left] = 0;
        std::vector<InkPiece> pieces = pieces_of(left, 128, false, 2 * line_.letter_height);
        std::erase_if(pieces, [&](const InkPiece& piece) {
            return !ends_within(piece, left) || piece.box.width() + piece.box.height() <= kSpeckle;
        });
        for (InkPiece& piece : pieces) move_piece(piece, window_.left, window_.top);
        return pieces;
    }

    bool touches_stroke(const InkPiece& piece) const {
        return std::any_of(piece.runs.begin(), piece.runs.end(), [&](const InkRun& run) {
            for (int y = run.y - 2; y <= run.y + 2; ++y)
                for (int x = run.left - 2; x < run.right + 2; ++x)
                    if (is_inside(x, y) && is_stroke(x, y)) return true;
            return false;
        });
    }

    std::vector<InkRun> strokes_in(const PixelBox& box) const {
        std::vector<InkRun> runs;
        for (int y = std::max(window_.top, box.top); y < std::min(window_.bottom, box.bottom); ++y)
            for (int x = std::max(window_.left, box.left); x < std::min(window_.right, box.right); ++x) {
                if (!is_stroke(x, y)) continue;
                if (!runs.empty() && runs.back().y == y && runs.back().right == x)
                    ++runs.back().right;
                else
                    runs.push_back({y, x, x + 1});
            }
        return runs;
    }

private:
    bool is_inside(int x, int y) const {
        return x >= window_.left && y >= window_.top && x < window_.right && y < window_.bottom;
    }
    bool is_stroke(int x, int y) const { return long_.strokes.row(y - window_.top)[x - window_.left] != 0; }
    bool is_drawn(int x, int y) const { return drawn_.row(y - seen_.top)[x - seen_.left] != 0; }

    static PixelBox within(const PixelBox& whole, const PixelBox& box) {
        return {std::max(whole.left, box.left), std::max(whole.top, box.top), std::min(whole.right, box.right),
                std::min(whole.bottom, box.bottom)};
    }

    // Letters are not drawn.
    void clear(const InkPiece& piece) {
        for (const InkRun& run : piece.runs)
            if (run.y >= seen_.top && run.y < seen_.bottom)
                for (int x = std::max(run.left, seen_.left); x < std::min(run.right, seen_.right); ++x)
                    drawn_.row(run.y - seen_.top)[x - seen_.left] = 0;
    }

    const LetteringLine& line_;
    PixelBox window_, seen_;  // the latter as far as strokes are followed
    Image drawn_;             // 1: ink of no letter, of what is seen
    LongStrokes long_;
};

bool is_in_row(const LetteringLine& line, const PixelBox& box) {
    const double out = kOutOfLine * line.letter_height;
    return box.top >= line.box.top - out && box.bottom <= line.box.bottom + out;
}

bool goes_on_in(const LetteringLine& line, const LetteringLine& other) {
    const double height = std::max(line.letter_height, other.letter_height);
    return !other.upwards && other.light == line.light &&
           std::abs(line.letter_height - other.letter_height) <= kAsHigh * height && is_in_row(line, other.box) &&
           gap_along(line.box, other.box) <= kGapBeside * height;
}

// Of degrees, which touches what is drawn at the level of grey of its figures.
bool is_sign_of(const LetteringLine& line, const LetteringLine& other) {
    const double height = line.letter_height;
    return !other.upwards && other.light == line.light && !is_words(other) && other.letter_height < kMark * height &&
           other.box.top >= line.box.top - kGapOfSign * height && other.box.bottom <= line.box.top + kMark * height &&
           other.box.left >= line.box.right - 1 && other.box.left - line.box.right <= kGapOfSign * height;
}

// At the end of a line it may be the tick of an axis, a minus sign, or what is seen of a letter; among letters it is one.
bool is_bar(const InkPiece& piece) {
    constexpr double kFilled = 0.75, kLong = 1.8;
    const double width = piece.box.width(), height = piece.box.height();
    return share_of_ink(piece) >= kFilled && std::max(width, height) >= kLong * std::min(width, height);
}

// The side of the largest square that is all ink, pixels: a stroke is as thick, and the head of an arrow thicker.
int thickest_square(const std::vector<InkPiece>& pieces) {
    int most = 0;
    for (const InkPiece& piece : pieces) {
        std::vector<int> above(static_cast<std::size_t>(piece.box.width()) + 1, 0), row(above);
        auto run = piece.runs.begin();
        for (int y = piece.box.top; y < piece.box.bottom; ++y) {
            std::fill(row.begin(), row.end(), 0);
            for (; run != piece.runs.end() && run->y == y; ++run)
                for (int x = run->left; x < run->right; ++x) {
                    const auto at = static_cast<std::size_t>(x - piece.box.left) + 1;
                    row[at] = 1 + std::min({above[at], above[at - 1], row[at - 1]});
                    most = std::max(most, row[at]);
                }
            above.swap(row);
        }
    }
    return most;
}

// In its row stands something, between its letters or no farther off than words are.
bool has_ink_beside(const Image& grey, const LetteringLine& line) {
    const int beyond = static_cast<int>(std::ceil(kGapBeside * line.letter_height));
    const PixelBox box{line.box.left - beyond, line.box.top, line.box.right + beyond, line.box.bottom};
    int ink = 0;
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) ink += is_ink(grey, line, x, y) ? 1 : 0;
    for (const auto* pieces : {&line.letters, &line.marks, &line.raised})
        for (const InkPiece& piece : *pieces)
            for (const InkRun& run : piece.runs)
                for (int x = run.left; x < run.right; ++x) ink -= is_ink(grey, line, x, run.y) ? 1 : 0;
    return ink > 0;
}

// A line, and what stands in line with it, freed or in lines of their own.
class Whole {
public:
    Whole(const Image& grey, const std::vector<LetteringLine>& lines, std::size_t number)
        : grey_(grey),
          lines_(lines),
          line_(lines[number]),
          whole_(line_),
          beside_(grey, line_, lines),
          used_(lines.size(), false) {
        used_[number] = true;
        const int thick = 2 * thickest_square(line_.letters) + 1;
        for (InkPiece& piece : beside_.freed()) {
            const bool bar = beside_.touches_stroke(piece) && is_bar(piece);
            (bar ? bars_ : thickest_square({piece}) < thick ? freed_ : blobs_).push_back(std::move(piece));
        }
    }

    // Nothing, where nothing touches it and nothing hides a letter of it.
    std::optional<FreedLine> run() {
        add_lines([](const LetteringLine& whole, const LetteringLine& other) { return is_sign_of(whole, other); });
        const LetteringLine untouched = whole_;
        Freed freed;
        bool touched = false;
        for (bool more = true; more;) {
            const std::vector<InkPiece> pieces = take_freed();
            for (const InkPiece& piece : pieces) {
                const bool touches = beside_.touches_stroke(piece);
                touched = touched || touches;
                freed.goes_on = freed.goes_on || (touches && is_as_letter(piece));
                add(piece);
            }
            more = (touched && add_lines([](const LetteringLine& whole, const LetteringLine& other) {
                        return is_sign_of(whole, other) || goes_on_in(whole, other);
                    })) ||
                   !pieces.empty();
        }
        constexpr double kRoom = 0.3;  // of the height
        if (!touched && !is_cut(grey_, line_, kRoom)) return std::nullopt;
        if (!touched) whole_ = untouched;
        for (const InkPiece& bar : bars_) {
            if (!is_next(bar)) continue;
            if (touched && around(whole_.box, bar.box).width() == whole_.box.width())
                add(bar);
            else
                freed.lacks = true;
        }
        const int high = whole_.letter_height, beyond = high / 4 + 2;
        whole_.veil = beside_.strokes_in(
            {whole_.box.left - high, whole_.box.top - beyond, whole_.box.right + high, whole_.box.bottom + beyond});
        for (const InkPiece& blob : blobs_) {
            if (!is_in_row(whole_, blob.box)) continue;
            whole_.veil.insert(whole_.veil.end(), blob.runs.begin(), blob.runs.end());
            // The head of an arrow may have a letter on it: "read" of "reads".
            const bool beyond_end = blob.box.left < whole_.box.left || blob.box.right > whole_.box.right;
            freed.lacks = freed.lacks || (beyond_end && gap_along(whole_.box, blob.box) <= kRoom * high);
        }
        return FreedLine{std::move(whole_), freed};
    }

private:
    // As tall as small letters, and level with one at its top or its foot.
    bool is_as_letter(const InkPiece& piece) const {
        return piece.box.height() >= kMark * line_.letter_height &&
               std::any_of(line_.letters.begin(), line_.letters.end(), [&](const InkPiece& letter) {
                   return std::abs(letter.box.top - piece.box.top) <= 1 || std::abs(letter.box.bottom - piece.box.bottom) <= 1;
               });
    }

    std::vector<InkPiece> take_freed() {
        std::vector<InkPiece> taken;
        std::erase_if(freed_, [&](InkPiece& piece) {
            const bool is = is_next(piece);
            if (is) taken.push_back(std::move(piece));
            return is;
        });
        return taken;
    }

    bool is_next(const InkPiece& piece) const {
        return is_in_row(line_, piece.box) && gap_along(whole_.box, piece.box) <= kGapBeside * whole_.letter_height;
    }

    template <typename Is>
    bool add_lines(Is is) {
        bool any = false;
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            if (used_[k] || !is(whole_, lines_[k])) continue;
            used_[k] = any = true;
            add(lines_[k]);
        }
        return any;
    }

    void add(const InkPiece& piece) {
        const bool mark = piece.box.height() < kMark * whole_.letter_height;
        if (mark)
            whole_.marks.push_back(piece);
        else
            add_letter(piece);
        grow(piece.box, mark ? 0 : piece.box.height());
    }

    void add(const LetteringLine& other) {
        for (const InkPiece& letter : other.letters) add_letter(letter);
        for (const InkPiece& letter : other.raised) add_letter(letter);
        whole_.marks.insert(whole_.marks.end(), other.marks.begin(), other.marks.end());
        grow(other.box, other.letter_height);
    }

    void add_letter(const InkPiece& letter) {
        const auto after = std::find_if(whole_.letters.begin(), whole_.letters.end(),
                                        [&](const InkPiece& other) { return other.box.left > letter.box.left; });
        whole_.letters.insert(after, letter);
    }

    void grow(const PixelBox& box, int height) {
        whole_.box = around(whole_.box, box);
        whole_.letter_height = std::max(whole_.letter_height, height);
    }

    const Image& grey_;
    const std::vector<LetteringLine>& lines_;
    const LetteringLine& line_;
    LetteringLine whole_;
    Beside beside_;
    std::vector<bool> used_;
    std::vector<InkPiece> freed_, bars_, blobs_;
};

}  // namespace

std::vector<FreedLine> freed_lines(const Image& grey, const std::vector<LetteringLine>& lines) {
    constexpr std::size_t kMostFreed = 60;  // of a picture; more is a text that is crossed out
    std::vector<FreedLine> freed;
    for (std::size_t i = 0; i < lines.size() && freed.size() < kMostFreed; ++i)
        if (!lines[i].upwards && has_ink_beside(grey, lines[i]))
            if (auto one = Whole(grey, lines, i).run(); one && !one->line.veil.empty()) freed.push_back(*std::move(one));
    return freed;
}

}  // namespace tactics
