// SPDX-License-Identifier: Apache-2.0
// Labels of which a part is hidden by what is drawn.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

#include "tactics/lettering/read_line.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Between the two in their row is ink that is none of theirs.
bool has_ink_between(const Image& grey, const LetteringLine& one, const LetteringLine& other) {
    const int left = std::min(one.box.right, other.box.right), right = std::max(one.box.left, other.box.left);
    for (int y = std::max(one.box.top, other.box.top); y < std::min(one.box.bottom, other.box.bottom); ++y)
        for (int x = left; x < right; ++x)
            if (is_ink(grey, one, x, y)) return true;
    return false;
}

// In its row, no farther off than a word is in monospaced print; and where a letter between them is hidden, somewhat farther.
bool stands_right_beside(const Image& grey, const LetteringLine& one, const LetteringLine& other) {
    constexpr double kOneHeight = 0.35, kOneFoot = 0.2;
    constexpr double kGap = 1.2, kGapOfHidden = 2.6;  // of the height; small letters stand beside figures. Settings
    if (one.upwards || other.upwards || one.light != other.light) return false;
    const double height = std::max(one.letter_height, other.letter_height);
    const int gap = gap_along(one.box, other.box);
    return std::abs(one.letter_height - other.letter_height) <= kOneHeight * height &&
           std::abs(one.box.bottom - other.box.bottom) <= kOneFoot * height + 1 && gap > 0 && gap <= kGapOfHidden * height &&
           (gap <= kGap * height || has_ink_between(grey, one, other));
}

// What is left of a word, the first letters of which touch what is drawn: behind them, each of its pieces reaches as far up and
// down as some letter of the label.
bool goes_on_behind_lines(const Image& grey, const LetteringLine& label, const LetteringLine& rest) {
    constexpr double kGap = 2;  // of the height
    if (label.upwards || rest.upwards || label.light != rest.light || !is_words(rest)) return false;
    const int gap = gap_along(label.box, rest.box);
    const auto is_of_label = [&](const InkPiece& piece) {
        return std::any_of(label.letters.begin(), label.letters.end(), [&](const InkPiece& letter) {
            return std::abs(letter.box.top - piece.box.top) <= 1 && std::abs(letter.box.bottom - piece.box.bottom) <= 1;
        });
    };
    return gap > 0 && gap <= kGap * label.letter_height && std::all_of(rest.letters.begin(), rest.letters.end(), is_of_label) &&
           has_ink_between(grey, label, rest);
}

bool is_of_label(const std::string& text) {
    return std::any_of(text.begin(), text.end(),
                       [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '='; });
}

bool has_figure(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](char c) { return is_digit(static_cast<unsigned char>(c)); });
}

// A part of a line without any of its ink, along it, and the rows across it that are looked at.
struct Gap {
    const Image& grey;
    const LetteringLine& line;
    int from, to, top, bottom;

    bool has_ink(int along, int across) const {
        return line.upwards ? is_ink(grey, line, across, along) : is_ink(grey, line, along, across);
    }

    // From above to below.
    bool is_crossed() const {
        bool through = to > from;
        for (int across = top; across < bottom && through; ++across) {
            through = false;
            for (int along = from; along < to && !through; ++along) through = has_ink(along, across);
        }
        return through;
    }

    // Nothing but a straight line, in the rows where there is ink; it leans so that no stem of a letter is behind it.
    bool is_line_that_leans() const {
        std::vector<double> middles;
        int thickest = 0, before = top;
        for (int across = top; across < bottom; ++across) {
            int first = to, last = from, ink = 0;
            for (int along = from; along < to; ++along) {
                if (!has_ink(along, across)) continue;
                first = std::min(first, along);
                last = along;
                ++ink;
            }
            if (ink == 0) continue;
            if (ink != last - first + 1 || (!middles.empty() && across != before + 1)) return false;
            before = across;
            thickest = std::max(thickest, ink);
            middles.push_back(0.5 * (first + last));
        }
        if (middles.size() < 2) return true;
        const double slope = (middles.back() - middles.front()) / static_cast<double>(middles.size() - 1);
        for (std::size_t i = 0; i < middles.size(); ++i)
            if (std::abs(middles[i] - middles.front() - slope * static_cast<double>(i)) > 1) return false;
        constexpr double kStem = 0.5;  // of what is looked at; an x is as high
        return std::abs(slope) * kStem * (bottom - top) > thickest + 1;
    }

    bool has_any_ink(int first, int last) const {
        for (int across = first; across < last; ++across)
            for (int along = from; along < to; ++along)
                if (has_ink(along, across)) return true;
        return false;
    }
};

// Ink that is none of its letters stands between two of them, and may be a part of one, or hide a point.
bool hides_in(const Gap& gap, bool has_points) {
    constexpr double kFoot = 0.35;  // of the height
    const PixelBox& box = gap.line.box;
    const int top = gap.line.upwards ? box.left : box.top, bottom = gap.line.upwards ? box.right : box.bottom;
    if (has_points) return gap.has_any_ink(bottom - static_cast<int>(kFoot * (bottom - top)), bottom);
    return gap.has_any_ink(top, bottom) && !gap.is_line_that_leans();
}

// A line that is drawn runs through it where there is none of its ink: a letter or a point may be hidden. No letter is where the
// line leans; a point may be.
bool is_parted(const Image& grey, const LetteringLine& line, bool has_points) {
    constexpr double kLeastGap = 0.25;  // of the height, where letters of a word have less between them
    const int beyond = std::max(2, line.letter_height / 4);
    const PixelBox& box = line.box;
    const int begin = line.upwards ? box.top : box.left, end = line.upwards ? box.bottom : box.right;
    const int top = std::max(0, (line.upwards ? box.left : box.top) - beyond);
    const int bottom = std::min(line.upwards ? grey.width : grey.height, (line.upwards ? box.right : box.bottom) + beyond);
    std::vector<bool> own(static_cast<std::size_t>(end - begin), false);
    for (const auto* pieces : {&line.letters, &line.marks, &line.raised})
        for (const InkPiece& piece : *pieces) {
            const int from = line.upwards ? piece.box.top : piece.box.left,
                      to = line.upwards ? piece.box.bottom : piece.box.right;
            std::fill(own.begin() + (std::clamp(from, begin, end) - begin), own.begin() + (std::clamp(to, begin, end) - begin),
                      true);
        }
    for (int from = begin; from < end;) {
        int to = from;
        while (to < end && !own[static_cast<std::size_t>(to - begin)]) ++to;
        const Gap gap{grey, line, from, to, top, bottom};
        if (gap.is_crossed() && (has_points || !gap.is_line_that_leans())) return true;
        if (to - from >= kLeastGap * line.letter_height && hides_in(gap, has_points)) return true;
        from = to + 1;
    }
    return false;
}

// All that stands between them is a dash, halfway up.
bool has_dash_between(const Image& grey, const LetteringLine& one, const LetteringLine& other) {
    constexpr double kThick = 0.25, kShortest = 0.2, kLongest = 0.9, kOffMiddle = 0.25;  // of the height
    const double height = std::max(one.letter_height, other.letter_height);
    const int left = std::min(one.box.right, other.box.right), right = std::max(one.box.left, other.box.left);
    const int top = std::max(0, std::min(one.box.top, other.box.top) - 1),
              bottom = std::min(grey.height, std::max(one.box.bottom, other.box.bottom) + 1);
    PixelBox dash{right, bottom, left, top};
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            if (is_ink(grey, one, x, y)) dash = around(dash, {x, y, x + 1, y + 1});
    if (dash.left <= left || dash.right >= right) return false;
    const double middle = (dash.top + dash.bottom) / 2.0, halfway = (one.box.top + one.box.bottom) / 2.0;
    return dash.height() <= std::max(2.0, kThick * height) && dash.width() >= kShortest * height &&
           dash.width() <= kLongest * height && std::abs(middle - halfway) <= kOffMiddle * height;
}

// "n = n" before "- 1".
bool is_part_of_formula(const Image& grey, const ReadLine& one, const std::vector<ReadLine>& all) {
    const auto has_equals = [](const ReadLine& line) { return line.words.text.find('=') != std::string::npos; };
    return std::any_of(all.begin(), all.end(), [&](const ReadLine& other) {
        return (has_equals(one) || has_equals(other)) && stands_right_beside(grey, one.line, other.line) &&
               has_dash_between(grey, one.line, other.line);
    });
}

}  // namespace

void doubt_parts(const Image& grey, std::vector<ReadLine>& lines, const std::vector<bool>& told) {
    const auto loses = [&](const ReadLine& one, const ReadLine& other, bool is_told) {
        if (other.words.sure || !is_words(other.line)) return false;
        return is_told ? is_of_label(other.words.text) && stands_right_beside(grey, one.line, other.line)
                       : is_of_label(one.words.text) && goes_on_behind_lines(grey, one.line, other.line);
    };
    for (bool more = true; more;) {
        more = false;
        for (ReadLine& one : lines)
            for (std::size_t i = 0; i < lines.size() && one.words.sure; ++i)
                if (loses(one, lines[i], told[i] || lines[i].tell)) {
                    one.words.sure = false;
                    one.tell = more = true;
                }
    }
}

void doubt_parted(const Image& grey, std::vector<ReadLine>& lines) {
    const std::vector<ReadLine> all = lines;
    for (ReadLine& one : lines)
        if (one.words.sure && (is_parted(grey, one.line, has_figure(one.words.text)) || is_part_of_formula(grey, one, all))) {
            one.words.sure = false;
            one.tell = true;
        }
}

}  // namespace tactics
