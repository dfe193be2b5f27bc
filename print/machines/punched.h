// SPDX-License-Identifier: Apache-2.0
// The output of a machine for the bytes it receives: the sheets, dot by dot. It is written from the facts of each protocol and
// independently of the encoders (machines/), so that one checks the other.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct PunchedSheet {
    std::vector<Point> dots;  ///< from the top left corner of the sheet, mm; in the order of the bytes
    /// For each dot, the share of full height; empty: all have full height. There may be millions of dots.
    std::vector<double> heights = {};
    /// Lines of cells, for a machine that takes only these; bit 0 = dot 1 ... bit 7 = dot 8.
    std::vector<std::vector<std::uint8_t>> lines = {};
    std::vector<std::uint8_t> apart = {};          ///< cells of a display's separate braille line
    std::size_t begin = 0;                         ///< its first byte, after the last byte of the previous sheet
    std::size_t end = 0;                           ///< one past its last byte
    std::size_t set_up_begin = 0, set_up_end = 0;  ///< the last set-up bytes before it

    double height_of(std::size_t dot) const { return heights.empty() ? 1 : heights[dot]; }
};

struct Punched {
    std::vector<PunchedSheet> sheets;
    std::size_t job_end_begin = 0, job_end_end = 0;  ///< the last bytes that ended a job; equal: none did
    /// Bytes that the machine would not understand, with their positions, and whether there are too many.
    std::vector<Phrase> notes;
};

/// A page with these dots on it, to be written in any format. Sheets have no size of their own.
Page page_of(const PunchedSheet& sheet, double width, double height, double dot);

/// Lines of Unicode braille: the lines of cells, or the dots on a raster of that pitch (mm), two across and four down per cell.
/// Empty cells are U+2800; those at the end of a line and empty lines at the end are dropped.
std::vector<std::string> unicode_of(const PunchedSheet& sheet, double pitch);

/// A line of cells, without the empty ones at its end.
std::string unicode_of(std::span<const std::uint8_t> cells);

}  // namespace tactics
