// SPDX-License-Identifier: Apache-2.0
// Histograms of pictures and edge maps, for contrast, kmeans and threshold.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// One level of a histogram and how many pixels have it.
struct Level {
    double value = 0;
    double weight = 0;
};

/// Counts of the 256 grey levels; a colour picture is counted by its luma.
std::array<std::uint64_t, 256> count_levels(const Image& image);

/// The same as levels 0 to 255, with those that do not occur (weight 0).
std::vector<Level> levels_of(const Image& image);

/// Strengths in bins of equal width from 0 to the largest; the value of a bin is its middle.
class StrengthHistogram {
public:
    static constexpr std::size_t kBins = 1024;

    /// All strengths, or only those above 0. They must be finite and not negative.
    StrengthHistogram(std::span<const float> strengths, bool only_positive);

    std::span<const Level> levels() const { return levels_; }
    /// The least strength that falls into the bin.
    float least_of(std::size_t bin) const;

private:
    float scale_ = 0;
    std::vector<Level> levels_;
};

}  // namespace tactics
