// SPDX-License-Identifier: Apache-2.0
// Heights as files: 16-bit PNG, 16-bit or floating-point TIFF, EXR, the container, and STL for 3-D printers.
//
// PNG, TIFF and EXR give the scale of their samples in mm, in entries that read_heights.h reads (tactics/relief/height_words.h).
// The same heights give the same bytes.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "tactics/coding/level_map.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

/// The metadata of a height file.
struct HeightSheet {
    int columns = 0, rows = 0;
    double pitch = 0;               ///< mm
    double low = 0, high = 0;       ///< heights of black and of white, mm; high is above low
    std::string_view profile = {};  ///< cross-section of lines: "round", "flat"; empty if there are none
};

/// Fills in the heights of a row, mm. It is called once for each row, from the top.
using HeightRows = std::function<void(int row, std::span<float> heights)>;

/// Heights are clamped to low and high.
std::string height_png(const HeightSheet& sheet, const HeightRows& rows);
std::string height_tiff(const HeightSheet& sheet, const HeightRows& rows);
/// 32-bit floating-point numbers, mm.
std::string height_tiff_decimal(const HeightSheet& sheet, const HeightRows& rows);
/// Its samples, with the fewest levels that represent them exactly.
LevelMap level_map_of(const HeightSheet& sheet, const HeightRows& rows);
/// The samples of the PNG in the container of tactics/coding, lossless and smaller.
std::string height_felt(const HeightSheet& sheet, const HeightRows& rows);
/// The same as OpenEXR, by the OpenImageIO module. Throws Error(failed) if that is not installed.
std::string height_exr(const HeightSheet& sheet, const HeightRows& rows);

/// A solid for 3-D printers and mills: binary STL in mm, with a flat bottom at 0, the height `low` at `base`, upright sides, as
/// large as the map from edge to edge. It is closed: each edge belongs to two triangles, all face outwards, and none has zero
/// area. Every sample is a corner, or lies on a flat surface between corners. Throws Error(usage) at `place` if it would have too
/// many triangles.
std::string height_stl(const HeightSheet& sheet, const HeightRows& rows, double base, std::string_view place);

/// The rows of a whole map, which must outlive them.
HeightSheet sheet_of(const HeightMap& map, double low, double high);
HeightRows rows_of(const HeightMap& map);

}  // namespace tactics
