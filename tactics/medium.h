// What is printed on: papers and the media that make a drawing felt. Two visible lists, papers.inc and media.inc.
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

/// Line widths and spacing that a finger can tell on one kind of page, in mm.
struct Medium {
    std::string_view name;
    std::string_view summary;
    double thin_line = 0;    ///< width of LineClass::thin; also the least width of any line
    double line = 0;         ///< LineClass::normal
    double thick_line = 0;   ///< LineClass::thick
    double gap = 0;          ///< least distance between two things, edge to edge
    double shortest = 0;     ///< a line shorter than this is not felt as a line
    double dpi = 0;          ///< pixels per inch of a picture beyond which nothing more can be felt
    double margin = 0;       ///< default margin on every side
    double braille_dot = 0;  ///< diameter of a drawn braille dot before it swells
};

std::span<const Paper> papers();
std::span<const Medium> media();

/// A named paper, or a size such as 200x150mm, 8.5x11in (turned upright). Throws Error(usage) with the nearest name.
Paper find_paper(std::string_view text, std::string_view place);
/// Throws Error(usage) with the nearest name.
const Medium& find_medium(std::string_view name, std::string_view place);

}  // namespace tactics
