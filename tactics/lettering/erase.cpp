// SPDX-License-Identifier: Apache-2.0
// The ground painted over the ink of words.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tactics/lettering/lettering.h"

namespace tactics {

namespace {

// From the picture that was looked at to one that shows the same at another size.
struct Scale {
    double across, down;
    int left(int x) const { return static_cast<int>(std::floor(x * across)); }
    int right(int x) const { return static_cast<int>(std::ceil(x * across)); }
    int top(int y) const { return static_cast<int>(std::floor(y * down)); }
    int bottom(int y) const { return static_cast<int>(std::ceil(y * down)); }
};

std::uint8_t middle_of(std::vector<std::uint8_t>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// One colour for a word: what most of the ground around its letters has. A mean of what is beside them would smear lines that
// pass by.
void paint(Image& picture, const PrintedWords& words, const Scale& scale) {
    constexpr int kAround = 3;  // pixels
    const int left = std::max(0, scale.left(words.box.left - kAround)),
              right = std::min(picture.width, scale.right(words.box.right + kAround));
    const int top = std::max(0, scale.top(words.box.top - kAround)),
              bottom = std::min(picture.height, scale.bottom(words.box.bottom + kAround));
    if (left >= right || top >= bottom) return;
    Image own = make_image(right - left, bottom - top, 1, 0, 0);
    for (const InkRun& run : words.ink)
        for (int y = std::max(top, scale.top(run.y)); y < std::min(bottom, scale.bottom(run.y + 1)); ++y) {
            const int from = std::max(left, scale.left(run.left)), to = std::min(right, scale.right(run.right));
            if (from < to) std::fill(own.row(y - top) + (from - left), own.row(y - top) + (to - left), std::uint8_t{1});
        }
    const int channels = picture.channels;
    const auto is_ground = [&](const std::uint8_t* pixel) {
        return ((channels == 3 ? luma(pixel) : *pixel) < words.level) == words.light;
    };
    std::array<std::vector<std::uint8_t>, 3> ground;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const std::uint8_t* pixel = picture.row(y) + x * channels;
            if (own.row(y - top)[x - left] != 0 || !is_ground(pixel)) continue;
            for (int c = 0; c < channels; ++c) ground[static_cast<std::size_t>(c)].push_back(pixel[c]);
        }
    if (ground[0].empty()) return;
    std::array<std::uint8_t, 3> colour{};
    for (int c = 0; c < channels; ++c) colour[static_cast<std::size_t>(c)] = middle_of(ground[static_cast<std::size_t>(c)]);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            if (own.row(y - top)[x - left] != 0) std::copy_n(colour.begin(), channels, picture.row(y) + x * channels);
}

}  // namespace

void take_out(Image& picture, const Lettering& lettering, bool only_sure) {
    if (lettering.words.empty() || picture.pixels.empty()) return;
    const Scale scale{static_cast<double>(picture.width) / lettering.width,
                      static_cast<double>(picture.height) / lettering.height};
    for (const PrintedWords& words : lettering.words)
        if (words.sure || words.out || (!only_sure && words.print)) paint(picture, words, scale);
}

}  // namespace tactics
