// SPDX-License-Identifier: Apache-2.0
// Print that no reader made out.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/lettering/form_line.h"
#include "tactics/lettering/known_print.h"
#include "tactics/lettering/mark_shape.h"
#include "tactics/lettering/print_company.h"
#include "tactics/lettering/read_line.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kSurelyRead = 80;     // of 100, of three letters: rows of marks are read with less. A setting
constexpr std::size_t kFewUnread = 8;  // where no print is known

struct Piece {
    const InkPiece* ink = nullptr;
    MarkShape shape;
    std::size_t line = 0;
    bool alone = false;  // in its line
    bool read = false;   // its line as likely words of several letters
    bool bent = false;   // a bent band
};

// What of the doubtful lines is drawn: marks of a plot and dashes.
class DrawnThings {
public:
    DrawnThings(const std::vector<ReadLine>& lines, const KnownPrint& known) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            in_line_.push_back(in_line_with_print(lines[i].line, known) || is_on_scale(i, lines));
            likely_.push_back(lines[i].likely);
            if (!is_doubtful(lines[i])) continue;
            for (const InkPiece& piece : lines[i].line.letters) pieces_.push_back(piece_of(piece, i, lines[i]));
        }
        for (const Piece& piece : pieces_)
            several_.push_back(are_several([&](const Piece& other) { return same_mark(piece.shape, other.shape); }));
    }

    // Nothing in it can only be a letter; but a pale 0 may come in two halves. A word has letters of many shapes.
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
        return unlike.empty() ? !in_line_[line] || !(upright || likely_[line]) : drawn && unlike.size() < kShapesOfWords;
    }

    // A piece of it is there several times.
    bool is_repeated(std::size_t line) const {
        return std::any_of(pieces_.begin(), pieces_.end(),
                           [&](const Piece& piece) { return piece.line == line && is_repeated(piece); });
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
    static Piece piece_of(const InkPiece& ink, std::size_t line, const ReadLine& of) {
        constexpr std::size_t kLetters = 3;  // two marks are read as two letters, but seldom three as three
        const MarkShape shape = mark_shape(ink);
        return {&ink,
                shape,
                line,
                !is_words(of.line),
                of.likely && of.line.letters.size() >= kLetters,
                is_letter_like(shape) && is_bent_band(ink)};
    }

    // Like one that is there several times: pixels may make a mark a little unlike the third.
    bool is_repeated(const Piece& piece) const {
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (several_[i] && same_mark(piece.shape, pieces_[i].shape)) return true;
        return false;
    }

    // The line of its middle letter, if that is a word: of at least four pieces at least two can only be letters.
    std::optional<std::size_t> letter_of(const std::vector<std::size_t>& group) const {
        constexpr std::size_t kLeast = 4, kLetters = 2;
        std::vector<std::size_t> letters;
        for (const std::size_t i : group)
            if (is_letter_like(pieces_[i].shape) && !pieces_[i].bent) letters.push_back(i);
        if (group.size() < kLeast || letters.size() < kLetters) return std::nullopt;
        return pieces_[letters[letters.size() / 2]].line;
    }

    static constexpr double kBesideDash = 0.8;  // of the mark
    static constexpr double kReach = 0.25;      // of what lies among others

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
        if (is_repeated(piece)) return true;
        if (piece.read) return false;
        if (piece.bent && !in_line_[piece.line] && is_among_dashes(piece)) return true;
        if (!in_line_[piece.line] && (is_among_marks(piece) || is_like_one_on_dashes(piece))) return true;
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
    bool is_among_marks(const Piece& piece) const {
        constexpr double kLeast = 1.15, kMost = 2.5;
        const MarkShape& shape = piece.shape;
        return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& mark) {
            const double side = shape.side / mark.shape.side, across = shape.across / mark.shape.across;
            const bool two = side >= kLeast && across >= kLeast && side <= kMost;
            return mark.alone && is_mark(mark.shape) && (two || same_size(shape, mark.shape)) &&
                   are_several_around(piece, kReach,
                                      [&](const Piece& other) { return other.alone && same_mark(mark.shape, other.shape); });
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

    bool is_among_dashes(const Piece& piece) const {
        return are_several_around(piece, kReach, [&](const Piece& other) { return other.bent || !is_letter_like(other.shape); });
    }

    // It lies where they lie: figures of an axis stand beside all that is drawn.
    template <typename Like>
    bool are_several_around(const Piece& piece, double reach, Like is_like) const {
        std::optional<PixelBox> all;
        for (const Piece& other : pieces_)
            if (&other != &piece && !in_line_[other.line] && is_like(other))
                all = all ? around(*all, other.ink->box) : other.ink->box;
        return all && gap_between(*all, piece.ink->box) <= reach * piece.shape.side && are_several(is_like);
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

    std::vector<bool> in_line_, likely_;
    std::vector<Piece> pieces_;
    std::vector<bool> several_;  // of each piece: there are several like it
};

// A word in line with print; its fractions and small letters are lower.
bool is_as_high_as_print(const LetteringLine& line, const KnownPrint& known) {
    constexpr double kOneHeight = 0.2;
    return is_words(line) && in_line_with_print(line, known) &&
           std::any_of(known.begin(), known.end(), [&](const LetteringLine* other) {
               return is_words(*other) &&
                      std::abs(line.letter_height - other->letter_height) <= kOneHeight * other->letter_height;
           });
}

// Most of its letters are no bars, and they, or the line, are as large as print that is known.
bool has_letters(const ReadLine& one, const KnownPrint& known, bool any_known) {
    const bool sized = !any_known || is_as_high_as_print(one.line, known);
    std::size_t letters = 0;
    for (const InkPiece& piece : one.line.letters) {
        const MarkShape shape = mark_shape(piece);
        letters += is_letter_like(shape) && (sized || as_large_as_print(shape, known)) ? 1 : 0;
    }
    return letters > 0 && 2 * letters >= one.line.letters.size() && one.line.marks.size() <= one.line.letters.size();
}

// A single letter that a font bears out, and no mark of a plot is read so well: those get 50 to 75 of 100.
bool is_letter_of_font(const ReadLine& one) {
    constexpr double kLikely = 80;  // a setting
    std::string_view text = one.words.text;
    if (text.empty() || one.line.letters.size() != 1 || one.words.sureness < kLikely) return false;
    const char32_t code = take_letter(text);
    return text.empty() && (is_digit(code) || (code | 32) - U'a' < 26 || code >= 0xC0) && !may_be_drawn(code);
}

// A bar may be drawn, and so may a ring; as high as a capital that is known, it may be an I all the same. In front of a sign of
// degrees a number may touch what is drawn.
bool is_bar_or_ring_of_font(const ReadLine& one, const KnownPrint& known) {
    constexpr double kSure = 90;  // a setting
    const bool bar = one.words.text == "I";
    if (one.line.letters.size() != 1 || one.words.sureness < kSure || (!bar && one.words.text != "\u00b0")) return false;
    return !bar || std::any_of(known.begin(), known.end(), [&](const LetteringLine* line) {
        return line->upwards == one.line.upwards && std::abs(line->letter_height - one.line.letter_height) <= 1;
    });
}

std::string letters_and_figures_of(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isalnum(c) == 0; });
    return text;
}

// Two readings of several letters agree in half of them or more: "no" and "ho".
bool is_half_read(const ReadLine& one) {
    const auto is_word = [](const std::string& text) {
        return text.size() > 1 && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
    };
    for (std::size_t i = 0; i < one.readings.size(); ++i)
        for (std::size_t k = i + 1; k < one.readings.size(); ++k) {
            const std::string &a = one.readings[i], &b = one.readings[k];
            if (a.size() != b.size() || !is_word(a) || !is_word(b)) continue;
            std::size_t same = 0;
            for (std::size_t c = 0; c < a.size(); ++c) same += a[c] == b[c] ? 1 : 0;
            if (2 * same >= a.size()) return true;
        }
    return false;
}

// More than any words have.
bool is_mostly_marks(const LetteringLine& line) { return line.marks.size() > 2 * line.letters.size() + 1; }

// Rows of equal marks, or pieces of a curve, are read as "°°°°", "OOO" or "f\\ I".
bool says_something(const std::string& text) {
    constexpr std::string_view kMarks = "OoQ0Il1xX";
    std::set<char> said;
    std::size_t count = 0;
    for (const char c : text) {
        const bool letter = (c >= '0' && c <= '9') || ((c | 32) >= 'a' && (c | 32) <= 'z');
        count += letter ? 1 : 0;
        if (letter && kMarks.find(c) == kMarks.npos) said.insert(c);
        if (c == '\\' || c == '|') return false;
    }
    return count >= 3 && said.size() >= 2;
}

// Several letters of a word that were read alike twice, whatever else was: "Ber" of "Berlin", through which a border runs.
bool is_begun_word(const ReadLine& one) {
    constexpr std::size_t kLetters = 3;
    if (one.readings.size() < 2) return false;
    const std::string first = letters_and_figures_of(one.readings[0]), second = letters_and_figures_of(one.readings[1]);
    return first == second && first.size() >= kLetters && one.line.letters.size() >= kLetters && says_something(first);
}

// Letters that all touch are one piece of ink, which the other reader was shown: it has read "RAM" and "RA".
bool is_joined_word(const ReadLine& one) {
    constexpr std::size_t kAlike = 2;
    if (is_words(one.line) || one.readings.size() < 2) return false;
    const std::string first = letters_and_figures_of(one.readings[0]), second = letters_and_figures_of(one.readings[1]);
    const std::size_t common = std::min(first.size(), second.size());
    return common >= kAlike && first.substr(0, common) == second.substr(0, common) &&
           says_something(first.size() > common ? first : second);
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
        if (!is_doubtful(one)) continue;
        const bool letter = is_letter_of_font(one) || is_bar_or_ring_of_font(one, known);
        const bool alone =
            (letter && !drawn.is_repeated(i)) || is_climbing_figure(i, lines, known) || (any_known && is_joined_word(one));
        if (alone && has_room_around(grey, one.line)) {
            unread[i] = true;
            continue;
        }
        if (drawn.has(i) || (is_mostly_marks(one.line) && !one.likely)) continue;
        if (!one.likely) {
            if (!has_letters(one, known, any_known) || (!any_known && one.line.light)) continue;
            // What touches a line may be a part of what is drawn.
            const bool read = any_known && ((in_line_with_print(one.line, known) && is_half_read(one)) || is_begun_word(one));
            if (!read && !has_room_around(grey, one.line)) continue;
            ++count;
        }
        unread[i] = true;
    }
    for (const std::size_t line : drawn.sloping(known)) unread[line] = true;
    if (!any_known && count > kFewUnread)
        for (std::size_t i = 0; i < lines.size(); ++i) unread[i] = unread[i] && lines[i].likely;
    return unread;
}

std::vector<bool> certain_print(const std::vector<ReadLine>& lines) {
    constexpr std::size_t kLetters = 3;          // two marks are read as two letters, but seldom three as three
    constexpr double kLow = 0.75, kHigh = 1.35;  // of the height of print that was read; settings
    KnownPrint sure;
    for (const ReadLine& one : lines)
        if (one.words.sure) sure.push_back(&one.line);
    std::vector<bool> certain(lines.size(), false);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const ReadLine& one = lines[i];
        const double height = one.line.letter_height;
        const bool sized = std::any_of(sure.begin(), sure.end(), [&](const LetteringLine* other) {
            return height >= kLow * other->letter_height && height <= kHigh * other->letter_height;
        });
        const bool word = (one.tell || one.likely) && one.line.letters.size() >= kLetters && says_something(one.words.text);
        // By itself, a mark of a plot in line with print looks like a letter or an unread one: figures of a scale are none.
        const bool figure = one.words.text.size() == 1 && one.words.text[0] >= '0' && one.words.text[0] <= '9';
        const bool in_line =
            sized && one.tell && (is_words(one.line) ? in_line_with_print(one.line, sure) : figure && is_on_scale(i, lines));
        certain[i] = !one.words.sure && ((word && (sized || one.words.sureness >= kSurelyRead)) || in_line);
    }
    return certain;
}

}  // namespace tactics
