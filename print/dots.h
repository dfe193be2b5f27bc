// SPDX-License-Identifier: Apache-2.0
// From a page to raised dots, for everything that uses dots instead of ink.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "tactics/layout/dot_grid.h"
#include "tactics/page.h"

namespace tactics {

struct Dots {
    int columns = 0;
    int rows = 0;
    std::vector<std::uint8_t> raised;  ///< 0 or 1, row by row from the top

    std::uint8_t& at(int column, int row) { return raised[index(column, row)]; }
    std::uint8_t at(int column, int row) const { return raised[index(column, row)]; }

private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
};

/// The drawing of a page (strokes, areas, picture; without its braille and print) as dots, each in its true place:
/// - a stroke is a chain of single dots (dot_chain.h), whatever its width;
/// - an area raises the dots inside (even-odd); one that is too narrow to hold a dot is drawn as its outline;
/// - a picture raises a dot where at least half of the paper around it is black, and along lines that are thinner.
/// Anything farther than one pitch outside the grid is left out.
Dots raise_dots(const Page& page, const DotGrid& grid);

/// The same with the page's braille on the raster of its machine, counted from the machine's first dot: the margin is empty, and
/// anything before that dot is left out. Each braille line begins at the nearest dot. Throws std::logic_error for a page of a
/// machine without a raster.
Dots raise_on_bed(const Page& page);

/// The same dots, each with 1 and the kind of the highest line through it in place of 1.
Dots kinds_on_bed(const Page& page);
inline LineKind kind_of_dot(std::uint8_t dot) { return static_cast<LineKind>(dot - 1); }  ///< of a dot that is not 0

/// Settings of a format whose dots have several heights, 0 leaving them to the page; the drawing's is the full height.
inline constexpr std::string_view kKindSettings[kLineKinds] = {"", "inner", "axes", "grid", "pattern"};

}  // namespace tactics
