// SPDX-License-Identifier: Apache-2.0
// Maps of regions against the regions that people drew, as the Berkeley benchmark scores them: covering, Probabilistic Rand Index
// and Variation of Information (P. Arbelaez, M. Maire, C. Fowlkes, J. Malik 2011; R. Unnikrishnan et al. 2007; M. Meila 2003).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tactics/measure/matching.h"

namespace tactics {

/// The region of each pixel, numbered from 0 in the order of their first pixels.
struct LabelMap {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> label;
    std::uint32_t regions = 0;
};

/// The parts that lines leave of a map: connected sets (by sides, not corners) of pixels without line. A line's own pixels belong
/// to the nearest part, so that every pixel counts, as in the benchmark, whose maps have a region at each pixel; of two as near
/// to that on the left or above, where the benchmark's line pixels belong. One region if there is nothing but line.
LabelMap regions_between(const PixelSet& lines);

/// Each label with what touches it by a side; labels may come again elsewhere. Throws std::logic_error if there are not
/// width x height labels.
LabelMap connected(std::span<const std::uint32_t> labels, int width, int height);

/// The same regions on a map of that size.
LabelMap resized(const LabelMap& map, int width, int height);

/// The pixels that differ in region from the next to the right, below or right below: the line that represents borders in the
/// benchmark's maps.
PixelSet borders_of(const LabelMap& map);

/// The overlap of two maps of the same pixels. Takes time in proportion to the pixels.
struct OverlapTable {
    struct Part {
        std::uint32_t first = 0, second = 0;  ///< labels
        long long pixels = 0;
    };
    long long pixels = 0;
    std::vector<long long> first, second;  ///< pixels of each label
    std::vector<Part> parts;               ///< those that are not empty
};
/// Labels are less than the number of pixels. Throws std::logic_error for others, or if there are not as many of both.
OverlapTable overlaps_of(std::span<const std::uint32_t> first, std::span<const std::uint32_t> second);

/// Covering of the second map by the first: the mean by area of each region's best overlap, intersection over union.
double covering(const OverlapTable& table);
/// Share of the pairs of pixels that both maps put together, or both apart; 1 for a single pixel.
double rand_index(const OverlapTable& table);
/// H(first | second) + H(second | first), in bits as in the benchmark's code; 0 if they are the same.
double variation_of_information(const OverlapTable& table);

/// One map of regions against all annotators: means over them.
struct RegionScore {
    double covering = 0;     ///< of an annotator's regions by the map's
    double rand = 0;         ///< Probabilistic Rand Index
    double information = 0;  ///< Variation of Information, bits; less is better
};

/// The levels at which a hierarchy is cut into regions, in grey levels, falling; the last is 0: all regions.
std::span<const float> region_levels();

/// One picture by one recipe.
struct RegionTrial {
    std::vector<RegionScore> curve;  ///< at each of region_levels(); empty: it could not be scored
    double best = 0;                 ///< covering if each of an annotator's regions may take the best of any level
    double weight = 0;               ///< pixels of all annotators
};
/// `maps` has one for each of region_levels(); neighbours that are the same object are scored once. At least one annotator.
RegionTrial score_regions(std::span<const std::shared_ptr<const LabelMap>> maps, std::span<const LabelMap> annotators);

/// Each annotator's regions against those of the others, the mean; not scored with fewer than two.
RegionTrial score_people(std::span<const LabelMap> annotators);

/// One map at all levels.
std::vector<std::shared_ptr<const LabelMap>> at_all_levels(LabelMap map);

/// A recipe, or people, over all pictures that were scored. ODS: one level for all pictures, the best for that measure; OIS: each
/// picture at its own. Coverings weigh pictures by their pixels and annotators; the other two are means of pictures, all as in
/// the benchmark.
struct RegionFigures {
    std::size_t pictures = 0;
    double covering_ods = 0, covering_ois = 0, covering_best = 0;
    double rand_ods = 0, rand_ois = 0;
    double information_ods = 0, information_ois = 0;
    float level = 0;  ///< of the covering's ODS
};
RegionFigures region_figures(std::span<const RegionTrial> trials);

}  // namespace tactics
