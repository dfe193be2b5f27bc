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

namespace tactics {

namespace {

int gap_between(const LetteringLine& one, const LetteringLine& other) {
    return std::max(one.box.left, other.box.left) - std::min(one.box.right, other.box.right);
}

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
    constexpr double kGap = 1.2, kGapOfHidden = 2;  // of the height; small letters stand beside figures. Settings
    if (one.upwards || other.upwards || one.light != other.light) return false;
    const double height = std::max(one.letter_height, other.letter_height);
    const int gap = gap_between(one, other);
    return std::abs(one.letter_height - other.letter_height) <= kOneHeight * height &&
           std::abs(one.box.bottom - other.box.bottom) <= kOneFoot * height + 1 && gap > 0 && gap <= kGapOfHidden * height &&
           (gap <= kGap * height || has_ink_between(grey, one, other));
}

// What is left of a word, the first letters of which touch what is drawn: behind them, each of its pieces reaches as far up and
// down as some letter of the label.
bool goes_on_behind_lines(const Image& grey, const LetteringLine& label, const LetteringLine& rest) {
    constexpr double kGap = 2;  // of the height
    if (label.upwards || rest.upwards || label.light != rest.light || !is_words(rest)) return false;
    const int gap = gap_between(label, rest);
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

// A line that is drawn runs through it from above to below, where there is none of its ink: a letter or a point may be hidden.
bool is_parted(const Image& grey, const LetteringLine& line) {
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
        bool through = to > from;
        for (int across = top; across < bottom && through; ++across) {
            through = false;
            for (int along = from; along < to && !through; ++along)
                through = line.upwards ? is_ink(grey, line, across, along) : is_ink(grey, line, along, across);
        }
        if (through) return true;
        from = to + 1;
    }
    return false;
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
    for (ReadLine& one : lines)
        if (one.words.sure && is_parted(grey, one.line)) {
            one.words.sure = false;
            one.tell = true;
        }
}

}  // namespace tactics
