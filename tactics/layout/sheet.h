// SPDX-License-Identifier: Apache-2.0
// The sheet: the user's requests for a page, before there is a drawing.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tactics/error.h"
#include "tactics/page.h"

namespace tactics {

enum class Orientation { automatic, portrait, landscape };

/// Extra room at an edge besides the margin, for holes, a comb or a spiral.
struct Binding {
    enum class Edge { left, top, right };
    Edge edge = Edge::left;
    double room = 0;  ///< mm
    bool operator==(const Binding&) const = default;
};

/// A page made of several adjoining sheets.
struct Tiles {
    int columns = 1;  ///< at most 9
    int rows = 1;     ///< at most 9
    bool several() const { return columns * rows > 1; }
};

/// The user's requests for a page, before there is a drawing.
struct Sheet {
    Paper paper;
    const Medium* medium = nullptr;
    Orientation orientation = Orientation::automatic;
    std::optional<double> margin;                   ///< mm on every side; the medium's if absent
    std::string margin_origin = spelled("margin");  ///< where the margin was given, for messages
    std::optional<Binding> binding;
    std::string binding_origin = spelled("binding");  ///< likewise
    /// Printed on both sides: every second page is the back of the one before it, where left and right change places; the back of
    /// a drawing stays blank.
    bool duplex = false;
    Tiles tiles;
    std::optional<double> drawing_width;  ///< mm; as large as fits if absent
    std::optional<double> real_width;     ///< real width of the drawing, mm; the page then has a scale bar
    std::optional<double> scale;          ///< mm on the page per mm in the world, with real_width; as large as fits if absent
    std::string title;                    ///< UTF-8, one line; empty = none
    std::string title_origin = spelled("title");  ///< where the title was given, for messages
    std::string caption;                          ///< UTF-8, one line; empty = none
    int title_cells = 0;  ///< cells of the machine's separate line for the title; 0: the title stands on the page
    /// For a display that shows a part of the page at a time: the size of that part, mm. No larger paper exists, and the pages of
    /// a key have this size.
    std::optional<Point> window;
    bool print_title = true;
    std::string braille_table = "en-ueb-g2.ctb";  ///< liblouis table for the title; empty = no braille
    CellSize cell = kMarburgMedium;
    std::optional<DotBed> bed;    ///< of the machine; nothing: cells in the middle of the live area
    DotHeights heights = {};      ///< of its dots
    double reach = 0;             ///< mm from the left edge up to which the machine can set dots; 0: the whole sheet
    bool bare = false;            ///< the page is the drawing: no margins, no title
    std::string description;      ///< description of the page by a person; empty = the program describes it
    std::string language = "en";  ///< BCP 47, of the title and of that description
};

}  // namespace tactics
