// SPDX-License-Identifier: Apache-2.0
// A picture cut into regions, each large enough to be felt.
#pragma once

#include <cstdint>
#include <vector>

namespace tactics {

/// The class of each pixel, row by row.
struct ClassMap {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> classes;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Pieces of one class, connected by the sides of pixels.
struct RegionMap {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> region;   ///< of each pixel
    std::vector<std::uint8_t> class_of;  ///< of each region

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};
RegionMap regions_of(const ClassMap& map);

/// Merges regions, from the narrowest to the widest, each into the neighbour with which it shares most border; border with a
/// similar neighbour counts more. Width is that of the largest disc within a region, in pixels; the picture's frame is a border,
/// too.
class Merging {
public:
    /// `apart[a][b]`: how different classes a and b look; border of that difference counts 1 / apart.
    Merging(RegionMap map, const std::vector<std::vector<double>>& apart);
    Merging(const ClassMap& map, const std::vector<std::vector<double>>& apart) : Merging(regions_of(map), apart) {}

    /// Continues until no region is narrower than `least` and there are at most `most`; always leaves one.
    void merge(double least, std::size_t most);
    std::size_t count() const { return count_; }
    double narrowest() const;  ///< width of the narrowest remaining region
    ClassMap result() const;
    RegionMap regions() const;  ///< with the numbers that the regions had

private:
    struct Neighbour {
        std::uint32_t region;
        std::uint32_t border;  // pixel sides
    };
    std::uint32_t root(std::uint32_t region) const;
    std::vector<Neighbour> neighbours_of(std::uint32_t region) const;
    void join(std::uint32_t from, std::uint32_t to);
    void merge_narrowest();

    RegionMap map_;
    std::vector<std::vector<double>> apart_;
    mutable std::vector<std::uint32_t> parent_;
    std::vector<std::vector<Neighbour>> neighbours_;  // may name merged regions; root() says into which
    std::vector<float> width_;
    std::vector<std::pair<float, std::uint32_t>> queue_;  // a heap, the narrowest first; entries of merged or grown regions stay
                                                          // in it
    std::size_t count_ = 0;
};

/// Gives parts of regions narrower than `width` pixels to the regions beside them.
ClassMap without_thin_parts(const ClassMap& map, double width);

/// If a region is narrower than `width` between two of its wide parts, or beside its own corner, the neighbour with most border
/// at the neck cuts through it, `width` wide.
ClassMap without_necks(const ClassMap& map, double width);

}  // namespace tactics
