// SPDX-License-Identifier: Apache-2.0
// What a machine makes of the bytes that it is sent: the sheets that come out, dot by dot. Written from the facts of each
// protocol and without the code that encodes it (machines/), so that one checks the other.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/page.h"

namespace tactics {

struct PunchedSheet {
    std::vector<Point> dots;  ///< from the left top corner of the sheet, mm; in the order in which they were sent
    /// Of each dot, the share of a dot's full height; none at all: all are as high as can be. There may be millions of dots.
    std::vector<double> heights = {};
    /// Lines of cells, of a machine that is sent nothing else; bit 0 = dot 1 ... bit 7 = dot 8.
    std::vector<std::vector<std::uint8_t>> lines = {};
    std::vector<std::uint8_t> apart = {};          ///< cells of a line that a display has besides its pins
    std::size_t begin = 0;                         ///< its first byte, behind the last of the sheet before it
    std::size_t end = 0;                           ///< the byte behind its last
    std::size_t set_up_begin = 0, set_up_end = 0;  ///< the bytes that last set the machine up before it

    double height_of(std::size_t dot) const { return heights.empty() ? 1 : heights[dot]; }
};

struct Punched {
    std::vector<PunchedSheet> sheets;
    std::size_t job_end_begin = 0, job_end_end = 0;  ///< the bytes that last ended a job; the same: none did
    std::vector<std::string>
        notes;  ///< what the machine would not understand, with the number of the byte; and if there is too much
};

/// A page with these dots on it, to be written in any format. Sheets have no size of their own.
Page page_of(const PunchedSheet& sheet, double width, double height, double dot);

/// Lines of Unicode braille: the lines of cells, or the dots on a raster of that pitch (mm), two across and four down a cell.
/// Empty cells are U+2800; those at the end of a line and lines at the end are left out.
std::vector<std::string> unicode_of(const PunchedSheet& sheet, double pitch);

/// A line of cells, without the empty ones at its end.
std::string unicode_of(std::span<const std::uint8_t> cells);

}  // namespace tactics
