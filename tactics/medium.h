// SPDX-License-Identifier: Apache-2.0
// What pages are made on: papers, and the media that make a drawing tactile. Three visible lists: papers.inc, media.inc,
// cells.inc.
#pragma once

#include <span>
#include <string_view>

namespace tactics {

/// A sheet, upright (width <= height), in mm.
struct Paper {
    std::string_view name;
    std::string_view summary;
    double width = 0;
    double height = 0;
};

/// Braille cell geometry in mm.
struct CellSize {
    double dot_pitch = 2.5;    ///< dot to dot within a cell
    double cell_pitch = 6.0;   ///< cell to cell
    double line_pitch = 10.0;  ///< line to line
    double dot = 1.6;          ///< diameter of a dot at its base

    bool operator==(const CellSize&) const = default;
};
inline constexpr CellSize kMarburgMedium{};  ///< the first of cells.inc

struct NamedCell {
    std::string_view name;
    std::string_view summary;
    CellSize size;
};

enum class Swells : bool { no, yes };
enum class FixedDots : bool { no, yes };

/// Line widths and spacing that a finger can distinguish on one kind of page, in mm.
struct Medium {
    std::string_view name;
    std::string_view summary;
    double thin_line = 0;                  ///< width of LineClass::thin; also the minimum width of any line
    double line = 0;                       ///< LineClass::normal
    double thick_line = 0;                 ///< LineClass::thick
    double gap = 0;                        ///< minimum distance between two things, edge to edge
    double shortest = 0;                   ///< a shorter line is not felt as a line
    double dpi = 0;                        ///< a picture with more pixels per inch would not feel any finer
    double margin = 0;                     ///< default margin on every side
    Swells swells = Swells::no;            ///< black parts rise when heated
    FixedDots fixed_dots = FixedDots::no;  ///< dots at fixed places only, with nothing between them
};

inline bool has_fixed_dots(const Medium& medium) { return medium.fixed_dots == FixedDots::yes; }
/// With fixed dots, middles of lines are two rows of dots apart: one row for the line, one that stays empty.
inline constexpr double kTwoRows = 2 * kMarburgMedium.dot_pitch;
/// Distance between the middles of two lines of these widths, mm, at which a finger feels two.
double least_apart(const Medium& medium, double width, double other_width);

std::span<const Paper> papers();
std::span<const Medium> media();
std::span<const NamedCell> cells();

/// A named paper, or a size such as 200x150mm, 8.5x11in (turned upright). Throws Error(usage) with the nearest name.
Paper find_paper(std::string_view text, std::string_view place);
/// Both throw Error(usage) with the nearest name.
const NamedCell& find_cell(std::string_view name, std::string_view place);
const Medium& find_medium(std::string_view name, std::string_view place);

}  // namespace tactics
