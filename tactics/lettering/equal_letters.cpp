// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/equal_letters.h"

#include <algorithm>
#include <cmath>

#include "tactics/lettering/ink.h"

namespace tactics {

namespace {

// How far their middles are apart along the row.
double middles_apart(const PixelBox& a, const PixelBox& b) { return std::abs(a.left + a.right - b.left - b.right) / 2.0; }

bool stand_side_by_side(const PixelBox& a, const PixelBox& b) {
    constexpr double kInRow = 0.5, kNextLetter = 0.8;  // settings, of the height
    const int both = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return both >= kInRow * std::min(a.height(), b.height()) && gap_along(a, b) < kNextLetter * std::max(a.height(), b.height());
}

// The letter right beside that one, before it in the order or behind; the order's size if there is none.
std::size_t beside_in(const std::vector<PixelBox>& boxes, const std::vector<std::size_t>& order, std::size_t from, int step) {
    const PixelBox& own = boxes[order[from]];
    // Before the first one the number is huge.
    for (std::size_t i = from + static_cast<std::size_t>(step); i < order.size(); i += static_cast<std::size_t>(step)) {
        const PixelBox& other = boxes[order[i]];
        if (stand_side_by_side(own, other)) return i;
        if (std::abs(other.left - own.left) > kMostInkHeight) break;
    }
    return order.size();
}

}  // namespace

bool is_space_of_equal_letters(const std::vector<PixelBox>& boxes, const std::vector<std::size_t>& order, std::size_t left,
                               std::size_t right) {
    constexpr double kUneven = 0.12;  // of a letter's width
    const std::size_t before = beside_in(boxes, order, left, -1), behind = beside_in(boxes, order, right, 1);
    if (before == order.size() || behind == order.size()) return false;
    const double one = middles_apart(boxes[order[before]], boxes[order[left]]),
                 other = middles_apart(boxes[order[right]], boxes[order[behind]]),
                 space = middles_apart(boxes[order[left]], boxes[order[right]]), letter = (one + other) / 2;
    return std::abs(one - other) <= kUneven * letter + 1 && std::abs(space - 2 * letter) <= kUneven * letter + 1;
}

}  // namespace tactics
