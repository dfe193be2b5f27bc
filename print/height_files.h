// SPDX-License-Identifier: Apache-2.0
// Heights as files: 16-bit PNG, TIFF of 16 bits or of decimal numbers, EXR, the container, and STL for 3-D printers.
//
// PNG, TIFF and EXR say what their samples are in mm, in entries that read_heights.h knows (tactics/relief/height_words.h). Same
// heights, same bytes.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "tactics/coding/level_map.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

/// What a file says of its heights.
struct HeightSheet {
    int columns = 0, rows = 0;
    double pitch = 0;               ///< mm
    double low = 0, high = 0;       ///< mm: of black and of white; high is over low
    std::string_view profile = {};  ///< cross-section of lines: "round", "flat"; empty if there are none
};

/// Fills in the heights of a row, mm. It is asked for each row once, from the top.
using HeightRows = std::function<void(int row, std::span<float> heights)>;

/// Heights outside of low to high are cut to it.
std::string height_png(const HeightSheet& sheet, const HeightRows& rows);
std::string height_tiff(const HeightSheet& sheet, const HeightRows& rows);
/// 32-bit decimal numbers, mm as they are.
std::string height_tiff_decimal(const HeightSheet& sheet, const HeightRows& rows);
/// Its samples, in the fewest levels that tell them all.
LevelMap level_map_of(const HeightSheet& sheet, const HeightRows& rows);
/// The samples of the PNG in the container of tactics/coding, without loss and smaller.
std::string height_felt(const HeightSheet& sheet, const HeightRows& rows);
/// The same as OpenEXR, by the OpenImageIO module. Throws Error(failed) if that is not installed.
std::string height_exr(const HeightSheet& sheet, const HeightRows& rows);

/// A solid for 3-D printers and mills: binary STL in mm, its bottom flat at 0, the height `low` at `base`, sides upright, as
/// large as the map from edge to edge. It is closed: each edge belongs to two triangles, which are turned outwards, and none is
/// without area. Every sample is a corner, or lies on a flat surface between corners. Throws Error(usage) at `place` if it would
/// have too many triangles.
std::string height_stl(const HeightSheet& sheet, const HeightRows& rows, double base, std::string_view place);

/// A whole map to those. It must outlive the rows.
HeightSheet sheet_of(const HeightMap& map, double low, double high);
HeightRows rows_of(const HeightMap& map);

}  // namespace tactics
