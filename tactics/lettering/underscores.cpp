// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/underscores.h"

#include <algorithm>

namespace tactics {

namespace {

// Settings, of the height of the tallest letter. An underscore has 0.5 to 0.6 em, capitals 0.7; it lies 0.08 to 0.24 em below
// the line.
constexpr double kShortestBar = 0.4, kLongestBar = 2.2, kFarthestBelow = 0.5, kBesideBar = 0.4, kOverFoot = 0.3;
constexpr double kThickBar = 0.25;
constexpr double kNextDash = 2;  // lengths of the bar to the next dash of a line

bool is_flat(const PixelBox& box) { return box.width() > 2 * box.height(); }

bool is_bar(const PixelBox& box, int height) {
    return box.width() >= kShortestBar * height && box.width() <= kLongestBar * height &&
           box.height() <= std::max(2.0, kThickBar * height) && is_flat(box);
}

bool covers(const PixelBox& bar, const PixelBox& letter) {
    return std::min(bar.right, letter.right) - std::max(bar.left, letter.left) > kSoftInk;
}

bool is_beside(const PixelBox& bar, const PixelBox& letter, int height) {
    return std::max(bar.left - letter.right, letter.left - bar.right) <= std::max(2.0, kBesideBar * height);
}

}  // namespace

bool is_underscore_between(const PixelBox& bar, const PixelBox& a, const PixelBox& b) {
    const int height = std::max(a.height(), b.height()), foot = std::min(a.bottom, b.bottom);
    return is_bar(bar, height) && !covers(bar, a) && !covers(bar, b) && is_beside(bar, a, height) && is_beside(bar, b, height) &&
           bar.top >= foot - kOverFoot * height && bar.top <= foot + kFarthestBelow * height;
}

Underscores::Underscores(const std::vector<PixelBox>& boxes) : boxes_(boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (is_flat(boxes[i])) bars_.push_back(i);
}

// There is a bar in the same row farther out.
bool Underscores::goes_on(const PixelBox& bar, bool to_left) const {
    return std::any_of(bars_.begin(), bars_.end(), [&](std::size_t i) {
        const PixelBox& other = boxes_[i];
        const int gap = to_left ? bar.left - other.right : other.left - bar.right;
        return gap > 0 && gap <= kNextDash * bar.width() && std::min(bar.bottom, other.bottom) > std::max(bar.top, other.top);
    });
}

std::vector<std::size_t> Underscores::of(const std::vector<std::size_t>& letters, int foot, int letter_height) const {
    std::vector<std::size_t> found;
    if (letters.empty()) return found;
    int left = boxes_[letters.front()].left, right = left;
    for (const std::size_t letter : letters) {
        left = std::min(left, boxes_[letter].left);
        right = std::max(right, boxes_[letter].right);
    }
    for (const std::size_t i : bars_) {
        const PixelBox& bar = boxes_[i];
        if (!is_bar(bar, letter_height) || bar.top < foot || bar.top > foot + kFarthestBelow * letter_height) continue;
        bool beside = false, under = false;
        for (const std::size_t letter : letters) {
            under = under || i == letter || covers(bar, boxes_[letter]);
            beside = beside || is_beside(bar, boxes_[letter], letter_height);
        }
        const bool dash = (bar.left < left && goes_on(bar, true)) || (bar.right > right && goes_on(bar, false));
        if (beside && !under && !dash) found.push_back(i);
    }
    return found;
}

}  // namespace tactics
