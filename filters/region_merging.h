// SPDX-License-Identifier: Apache-2.0
// Merges regions, the most similar and least divided first, until the whole picture is one.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "tactics/region_tree.h"

namespace tactics {

/// Additive properties of a region, for comparison with others.
struct RegionSums {
    static constexpr std::size_t kShades = 12;   ///< bins of lightness, of a* and of b*
    static constexpr std::size_t kTextures = 8;  ///< bins of how rough it is
    double area = 0;
    std::array<double, 3> colour{};
    std::array<std::array<float, kShades>, 3> shades{};
    std::array<float, kTextures> rough{};

    RegionSums& operator+=(const RegionSums& other);
};

/// The sums of each face. `planes`: CIELAB of each pixel.
std::vector<RegionSums> sums_of(std::span<const std::uint32_t> face, std::size_t faces,
                                const std::vector<std::vector<float>>& planes, int width, int height);

/// The boundary that two regions share.
struct SharedBorder {
    double length = 0;    ///< sides of pixels
    double strength = 0;  ///< sum along it of the map's, 0 to 255
};

inline constexpr std::size_t kPairFeatures = 11;
using PairFeatures = std::array<double, kPairFeatures>;
/// The differences of two regions: boundary, lightness, colour, texture, mean colour, size, and combinations of these; the last
/// is 1.
PairFeatures features_of(const RegionSums& a, const RegionSums& b, const SharedBorder& border);

/// The weights of the features. Merging uses the probability that people would draw the border, 1 / (1 + exp(-weights .
/// features)).
using PairWeights = std::array<double, kPairFeatures>;

/// Called with computed features, for fitting.
using PairWatcher = std::function<void(std::uint32_t a, std::uint32_t b, const PairFeatures&)>;

/// Makes the tree's nodes and levels from its faces, arcs and their strengths. Regions smaller than `least` square pixels merge
/// before all others, at level 0.
void merge_regions(RegionTree& tree, std::vector<RegionSums> sums, double least, const PairWeights& weights,
                   const PairWatcher& watcher = {});

}  // namespace tactics
