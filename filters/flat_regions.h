// SPDX-License-Identifier: Apache-2.0
// A picture of plain colours, such as a political map, as its regions.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// A region grows from a piece of one colour: its pixels and their neighbours differ by less than compression and scaling leave.
/// What is in no such piece (outlines, letters, blur) goes to the nearest, so that two regions meet in the middle of the line
/// between them. Two pieces of one colour with a line between them are two regions.
struct FlatRegions {
    int width = 0, height = 0;
    std::vector<std::uint32_t> region;                ///< of each pixel
    std::vector<float> wide;                          ///< of each region: its largest disc, in pixels
    std::vector<std::array<std::uint8_t, 3>> colour;  ///< of each region
    std::vector<bool> flat;                           ///< of each pixel: in the piece that its region grew from
    std::vector<std::uint8_t> unlike;  ///< of each pixel: levels, in the channel of most, from the colour of its region

    std::size_t count() const { return wide.size(); }
    /// Whether something is drawn on the region there.
    bool is_line(std::size_t pixel) const {
        constexpr std::uint8_t kLineStep = 40;  // levels; compression leaves less
        return unlike[pixel] > kLineStep;
    }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Pieces narrower than `least` pixels are none; nor are long ones narrower than `road`, which are streets and rivers between
/// regions. No regions where nothing is flat.
FlatRegions flat_regions_of(const Image& picture, double least, double road);

/// How much a picture looks like a map of coloured regions.
struct MapTraits {
    double flat = 0;          ///< share of it in pieces of one colour
    double bordering = 0;     ///< of the borders, between two regions of which neither is of the ground's colour
    double straight = 0;      ///< of those borders, the share in straight pieces: of a mosaic, a pie or stacked bars nearly all
    double explained = 0;     ///< of the pixels of lines, those at the borders of regions
    std::size_t regions = 0;  ///< that a finger could tell, without those of the ground's colour
    std::size_t colours = 0;  ///< of these
};
MapTraits map_traits_of(const Image& picture);
bool is_coloured_map(const MapTraits& traits);

}  // namespace tactics
