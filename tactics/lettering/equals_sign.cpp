// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/equals_sign.h"

#include <algorithm>
#include <cstdlib>

namespace tactics {

namespace {

// Of the height of an x, of which the sign has 0.6 and is 1.6 times as wide in TeX. The plates of a capacitor are wider and
// farther apart. Settings, with a pixel for rounding.
constexpr double kSignWidth = 2.2, kSignHeight = 0.75;
constexpr double kSignGap = 1.5;  // of the height; the room around the sign is wider than a word space

// An equals sign: two strokes as long as each other, one above the other. Together they stand in line with letters.
bool are_equals_sign(const PixelBox& upper, const PixelBox& lower) {
    const int width = std::max(upper.width(), lower.width());
    return upper.bottom < lower.top && lower.bottom - upper.top <= 0.8 * width && 3 * upper.height() <= width &&
           3 * lower.height() <= width && width >= kLeastInkHeight && width <= kMostInkHeight &&
           std::abs(upper.left - lower.left) <= 1 && std::abs(upper.right - lower.right) <= 1;
}

// Beside a sign stands a letter of its line, as high as both strokes. Beside two samples of a legend, whose lines are as far
// apart as its rows, each letter stands beside one of them.
bool stands_beside(const PixelBox& letter, const PixelBox& upper, const PixelBox& lower) {
    const PixelBox sign = around(upper, lower);
    const int gap = std::max(letter.left - sign.right, sign.left - letter.right);
    const double reach = kSignGap * std::max(letter.height(), sign.height());
    return letter.height() >= kLeastInkHeight && sign.width() <= kSignWidth * letter.height() &&
           sign.height() <= kSignHeight * letter.height() + 1 && gap >= 0 && gap <= reach && letter.top < upper.bottom &&
           letter.bottom > lower.top;
}

}  // namespace

std::vector<bool> join_equals_signs(std::vector<InkPiece>& pieces) {
    std::vector<std::size_t> strokes;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (pieces[i].box.width() >= 3 * pieces[i].box.height() && pieces[i].box.width() <= kMostInkHeight) strokes.push_back(i);
    std::stable_sort(strokes.begin(), strokes.end(),
                     [&](std::size_t a, std::size_t b) { return pieces[a].box.left < pieces[b].box.left; });
    const auto in_line = [&](const PixelBox& upper, const PixelBox& lower) {
        return std::any_of(pieces.begin(), pieces.end(),
                           [&](const InkPiece& piece) { return stands_beside(piece.box, upper, lower); });
    };
    std::vector<bool> gone(pieces.size(), false), joined(pieces.size(), false);
    for (std::size_t i = 0; i < strokes.size(); ++i)
        for (std::size_t k = i + 1; k < strokes.size(); ++k) {
            InkPiece &a = pieces[strokes[i]], &b = pieces[strokes[k]];
            if (b.box.left > a.box.left + 1) break;
            if (gone[strokes[i]] || gone[strokes[k]]) continue;
            const bool a_first = a.box.top < b.box.top;
            const PixelBox &upper = a_first ? a.box : b.box, &lower = a_first ? b.box : a.box;
            if (!are_equals_sign(upper, lower) || !in_line(upper, lower)) continue;
            a.box = around(a.box, b.box);
            a.runs.insert(a.runs.end(), b.runs.begin(), b.runs.end());
            joined[strokes[i]] = gone[strokes[k]] = true;
        }
    std::size_t at = 0;
    std::erase_if(joined, [&](bool) { return gone[at++]; });
    at = 0;
    std::erase_if(pieces, [&](const InkPiece&) { return gone[at++]; });
    return joined;
}

}  // namespace tactics
