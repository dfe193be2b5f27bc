// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/signs_between.h"

#include <algorithm>
#include <cstdlib>

#include "tactics/lettering/underscores.h"

namespace tactics {

namespace {

// Of those from `left` on that end before `right`.
template <typename Is>
bool any_of(const std::vector<PixelBox>& signs, int left, int right, const Is& is) {
    auto sign = std::lower_bound(signs.begin(), signs.end(), left, [](const PixelBox& one, int from) { return one.left < from; });
    for (; sign != signs.end() && sign->right <= right; ++sign)
        if (is(*sign)) return true;
    return false;
}

}  // namespace

SignsBetween::SignsBetween(const std::vector<PixelBox>& boxes) {
    constexpr int kMostHeight = 12;  // pixels, of print that is as high as it may be
    for (const PixelBox& box : boxes) {
        if (box.height() > kMostHeight) continue;
        if (box.width() <= box.height() + 1) points_.push_back(box);
        if (box.width() > 2 * box.height()) bars_.push_back(box);
    }
    for (std::vector<PixelBox>* all : {&points_, &bars_})
        std::sort(all->begin(), all->end(), [](const PixelBox& a, const PixelBox& b) { return a.left < b.left; });
}

bool SignsBetween::any_point(const PixelBox& a, const PixelBox& b) const {
    constexpr double kOffFoot = 0.2, kLeast = 0.12, kMost = 0.3;  // of the height; specks of noise are smaller
    const int foot = std::min(a.bottom, b.bottom), height = std::max(a.height(), b.height());
    return any_of(points_, a.right, b.left, [&](const PixelBox& one) {
        return std::min(one.width(), one.height()) >= kLeast * height && one.height() <= std::max(2.0, kMost * height) &&
               std::abs(one.bottom - foot) <= std::max(1.0, kOffFoot * height);
    });
}

bool SignsBetween::any_minus(const PixelBox& a, const PixelBox& b) const {
    constexpr double kLeast = 0.35, kMost = 1.1, kHigh = 0.25, kLow = 0.8, kBeside = 0.5;  // of the height
    const int foot = std::max(a.bottom, b.bottom), height = std::max(a.height(), b.height());
    return any_of(bars_, a.right, b.left, [&](const PixelBox& one) {
        return one.width() >= kLeast * height && one.width() <= kMost * height && foot - one.bottom >= kHigh * height &&
               foot - one.top <= kLow * height && one.left - a.right <= kBeside * height &&
               b.left - one.right <= kBeside * height;
    });
}

bool SignsBetween::any_underscore(const PixelBox& a, const PixelBox& b) const {
    return any_of(bars_, a.right - kSoftInk, b.left + kSoftInk,
                  [&](const PixelBox& one) { return is_underscore_between(one, a, b); });
}

}  // namespace tactics
