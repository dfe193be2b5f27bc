// SPDX-License-Identifier: Apache-2.0
#include "filters/watershed.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "filters/opencv.h"

namespace tactics {

namespace {

constexpr std::uint32_t kNoBasin = 0xffffffff;
constexpr double kMinimumBlur = 1;  // pixels; a minimum narrower than that is chance
constexpr int kReach = 2;           // a minimum is the least of 5x5 pixels
constexpr int kHeights = 2048;      // of 255 grey levels; what is left of equal height floods in the order in which it is reached

std::vector<std::uint16_t> heights_of(const EdgeMap& map) {
    cv::Mat blurred;
    cv::GaussianBlur(view_of(map), blurred, cv::Size(), kMinimumBlur, kMinimumBlur, cv::BORDER_REPLICATE);
    std::vector<std::uint16_t> heights(map.strength.size());
    const float* strength = blurred.ptr<float>();
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = static_cast<std::uint16_t>(
            std::clamp(std::lround(strength[i] * (kHeights / 256.0f)), 0L, static_cast<long>(kHeights - 1)));
    return heights;
}

// Pixels that have none lower within their 5x5; those that touch, by a corner even, are one minimum.
std::vector<std::uint32_t> minima_of(std::vector<std::uint16_t>& heights, int width, int height) {
    const cv::Mat view(height, width, CV_16U, heights.data());
    cv::Mat least;
    cv::erode(view, least, cv::getStructuringElement(cv::MORPH_RECT, {2 * kReach + 1, 2 * kReach + 1}));
    std::vector<std::uint32_t> label(heights.size(), kNoBasin), front;
    std::uint32_t count = 0;
    const auto is_least = [&](std::size_t i) { return heights[i] == least.ptr<std::uint16_t>()[i]; };
    for (std::size_t start = 0; start < heights.size(); ++start) {
        if (label[start] != kNoBasin || !is_least(start)) continue;
        label[start] = count;
        front.assign(1, static_cast<std::uint32_t>(start));
        while (!front.empty()) {
            const int x = static_cast<int>(front.back()) % width, y = static_cast<int>(front.back()) / width;
            front.pop_back();
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
                    const std::size_t i =
                        static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
                    if (label[i] != kNoBasin || !is_least(i)) continue;
                    label[i] = count;
                    front.push_back(static_cast<std::uint32_t>(i));
                }
        }
        ++count;
    }
    return label;
}

}  // namespace

std::vector<std::uint32_t> basins_of(const EdgeMap& map) {
    const int width = map.width, height = map.height;
    std::vector<std::uint16_t> heights = heights_of(map);
    std::vector<std::uint32_t> label = minima_of(heights, width, height);
    std::vector<std::vector<std::uint32_t>> waiting(kHeights);
    const auto neighbours = [&](std::uint32_t i, auto&& visit) {
        const int x = static_cast<int>(i) % width;
        if (x > 0) visit(i - 1);
        if (x + 1 < width) visit(i + 1);
        if (i >= static_cast<std::uint32_t>(width)) visit(i - static_cast<std::uint32_t>(width));
        if (i + static_cast<std::uint32_t>(width) < label.size()) visit(i + static_cast<std::uint32_t>(width));
    };
    // Who waits has its basin already: that of the neighbour from which it was reached first.
    for (std::uint32_t i = 0; i < label.size(); ++i)
        if (label[i] != kNoBasin) waiting[heights[i]].push_back(i);
    for (std::size_t level = 0; level < waiting.size(); ++level)
        for (std::size_t n = 0; n < waiting[level].size(); ++n) {
            const std::uint32_t from = waiting[level][n];
            neighbours(from, [&](std::uint32_t i) {
                if (label[i] != kNoBasin) return;
                label[i] = label[from];
                waiting[std::max<std::size_t>(heights[i], level)].push_back(i);
            });
        }
    // A minimum of pixels that touch by a corner may be two pieces for those who walk by sides; each piece is a basin of its own.
    std::vector<std::uint32_t> basin(label.size(), kNoBasin), front;
    std::uint32_t count = 0;
    for (std::uint32_t start = 0; start < label.size(); ++start) {
        if (basin[start] != kNoBasin) continue;
        basin[start] = count;
        front.assign(1, start);
        while (!front.empty()) {
            const std::uint32_t from = front.back();
            front.pop_back();
            neighbours(from, [&](std::uint32_t i) {
                if (basin[i] != kNoBasin || label[i] != label[start]) return;
                basin[i] = count;
                front.push_back(i);
            });
        }
        ++count;
    }
    return basin;
}

}  // namespace tactics
