// SPDX-License-Identifier: Apache-2.0
// The sheet: what the user asks of a page, before there is a drawing.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tactics/error.h"
#include "tactics/page.h"

namespace tactics {

enum class Orientation { automatic, portrait, landscape };

/// Room at an edge besides the margin, for holes, a comb or a spring.
struct Binding {
    enum class Edge { left, top, right };
    Edge edge = Edge::left;
    double room = 0;  ///< mm
    bool operator==(const Binding&) const = default;
};

/// A page of several sheets that are laid together.
struct Tiles {
    int columns = 1;  ///< at most 9
    int rows = 1;     ///< at most 9
    bool several() const { return columns * rows > 1; }
};

/// What the user asks of a page, before there is a drawing.
struct Sheet {
    Paper paper;
    const Medium* medium = nullptr;
    Orientation orientation = Orientation::automatic;
    std::optional<double> margin;                   ///< mm on every side; the medium's if absent
    std::string margin_origin = spelled("margin");  ///< what a message about the margin points to
    std::optional<Binding> binding;
    std::string binding_origin = spelled("binding");  ///< likewise
    /// Printed on both sides: every second page is the back of the one before it, where left and right change places, and
    /// nothing stands on the back of a drawing.
    bool duplex = false;
    Tiles tiles;
    std::optional<double> drawing_width;  ///< mm; as large as fits if absent
    std::optional<double> real_width;     ///< mm that the drawing's width is in the world; a scale bar says so
    std::optional<double> scale;          ///< mm on the page for a mm in the world, with real_width; as large as fits if absent
    std::string title;                    ///< UTF-8, one line; empty = none
    std::string title_origin = spelled("title");  ///< what a message about the title points to
    std::string caption;                          ///< UTF-8, one line; empty = none
    int title_cells = 0;  ///< of a line that the machine has for the title besides; 0: it stands on the page
    /// Of a display that shows so much of the page at a time, mm: there is no larger paper, and the pages of a key are of that
    /// size.
    std::optional<Point> window;
    bool print_title = true;
    std::string braille_table = "en-ueb-g2.ctb";  ///< liblouis table for the title; empty = no braille
    CellSize cell = kMarburgMedium;
    std::optional<DotBed> bed;    ///< of the machine that it is for; nothing: cells in the middle of the live area
    double reach = 0;             ///< mm from its left edge, as far as the machine sets dots; 0: all of it
    bool bare = false;            ///< the page is the drawing: no margins, no title
    std::string description;      ///< a person's words for what is on the page; empty = it is described by what it is
    std::string language = "en";  ///< BCP 47, of the title and of those words
};

}  // namespace tactics
