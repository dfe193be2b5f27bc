// SPDX-License-Identifier: Apache-2.0
#include "filters/histogram.h"

#include <algorithm>
#include <cmath>

namespace tactics {

std::array<std::uint64_t, 256> count_levels(const Image& image) {
    if (image.channels != 1) return count_levels(to_grey(image));
    // Four tables in turn: neighbours are often alike, and a counter that was just written is slow to read again.
    std::array<std::array<std::uint64_t, 256>, 4> tables{};
    const std::size_t count = image.pixels.size();
    const std::uint8_t* at = image.pixels.data();
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (std::size_t t = 0; t < 4; ++t) ++tables[t][at[i + t]];
    for (; i < count; ++i) ++tables[0][at[i]];
    for (std::size_t t = 1; t < 4; ++t)
        for (std::size_t v = 0; v < 256; ++v) tables[0][v] += tables[t][v];
    return tables[0];
}

std::vector<Level> levels_of(const Image& image) {
    std::vector<Level> levels;
    levels.reserve(256);
    for (const auto count : count_levels(image))
        levels.push_back({static_cast<double>(levels.size()), static_cast<double>(count)});
    return levels;
}

namespace {

// In lanes, because a single running maximum waits for itself.
float largest_of(std::span<const float> values) {
    std::array<float, 16> lanes{};
    std::size_t i = 0;
    for (; i + lanes.size() <= values.size(); i += lanes.size())
        for (std::size_t lane = 0; lane < lanes.size(); ++lane) lanes[lane] = std::max(lanes[lane], values[i + lane]);
    for (; i < values.size(); ++i) lanes[0] = std::max(lanes[0], values[i]);
    return *std::max_element(lanes.begin(), lanes.end());
}

}  // namespace

StrengthHistogram::StrengthHistogram(std::span<const float> strengths, bool only_positive) : levels_(kBins) {
    const float largest = largest_of(strengths);
    // A largest strength so small that the division overflows is as good as none: everything falls into the first bin.
    const float scale = static_cast<float>(kBins) / std::max(largest, 1e-30f);
    scale_ = largest > 0 ? scale : 0;
    std::array<std::array<std::uint32_t, kBins>, 4> tables{};
    for (std::size_t i = 0; i < strengths.size(); ++i)
        ++tables[i % 4][std::min(kBins - 1, static_cast<std::size_t>(strengths[i] * scale_))];
    if (only_positive) tables[0][0] -= static_cast<std::uint32_t>(std::count(strengths.begin(), strengths.end(), 0.0f));
    for (std::size_t i = 0; i < kBins; ++i) {
        // In unsigned numbers the sum comes out right even if the first table alone went below 0.
        const std::uint32_t count = tables[0][i] + tables[1][i] + tables[2][i] + tables[3][i];
        levels_[i] = {(static_cast<double>(i) + 0.5) * static_cast<double>(largest) / kBins, static_cast<double>(count)};
    }
}

float StrengthHistogram::least_of(std::size_t bin) const {
    if (bin == 0 || scale_ <= 0) return 0;
    // The division may miss by a rounding; the multiplication is what the counting went by.
    const auto lower = static_cast<float>(bin);
    float least = lower / scale_;
    while (least * scale_ < lower) least = std::nextafter(least, INFINITY);
    while (std::nextafter(least, 0.0f) * scale_ >= lower) least = std::nextafter(least, 0.0f);
    return least;
}

}  // namespace tactics
