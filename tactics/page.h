// SPDX-License-Identifier: Apache-2.0
// The page: a drawing on a sheet of a medium, fully resolved. Every output format draws this and nothing else.
//
// After lay_out there are none of these: a position off the paper; a line thinner than the medium's thinnest; a line
// class, a unit or a scale still to be worked out; text still to be translated into braille, or text that is not one line
// of valid UTF-8 without control characters; grey.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/medium.h"

namespace tactics {

struct Rect {
    double left = 0, top = 0, width = 0, height = 0;  ///< mm

    Point middle() const { return {left + width / 2, top + height / 2}; }
    bool holds(Point p) const { return p.x >= left && p.x <= left + width && p.y >= top && p.y <= top + height; }
};

/// Where a machine can raise dots on its sheet. Its braille cells are the page's.
struct DotBed {
    Point first;        ///< centre of the first dot, from the left top corner of the sheet
    double raster = 0;  ///< dots stand so far apart, mm, all over; 0: in its cells only
    int dots_down = 3;  ///< of a cell; 4 with dots 7 and 8

    /// From one place where a cell can begin to the next, mm.
    double across(const CellSize& cell) const { return raster > 0 ? raster : cell.cell_pitch; }
    double down(const CellSize& cell) const { return raster > 0 ? raster : cell.line_pitch; }
    bool operator==(const DotBed& other) const {
        return first.x == other.first.x && first.y == other.first.y && raster == other.raster && dots_down == other.dots_down;
    }
};

/// A row of braille cells. Dots are drawn from it in mm; text formats take the cells.
struct BrailleLine {
    Point first_dot;                  ///< centre of dot 1 of the first cell
    std::vector<std::uint8_t> cells;  ///< bit 0 = dot 1 ... bit 5 = dot 6 (bits 6, 7 = dots 7, 8)
};

/// One line of print for sighted helpers.
struct PrintLine {
    Point baseline;   ///< left end
    double size = 0;  ///< letter size (em) in mm
    std::string text;
};

struct PageStroke {
    std::vector<Point> points;
    bool closed = false;
    double width = 0;  ///< mm; round ends and joins
    Role role = Role::line;
};

/// A black-and-white picture: 1 bit a pixel, rows packed to bytes, most significant bit left, 1 = black.
struct Bitmap {
    int width = 0;
    int height = 0;
    Rect place;  ///< mm
    std::vector<std::uint8_t> bits;
    std::size_t row_bytes() const { return (static_cast<std::size_t>(width) + 7) / 8; }
};

/// What is darker than half of a grey picture is black.
Bitmap to_bitmap(const Image& grey, const Rect& place);

/// The name of a thing in the drawing, as it was set: its cells are among the page's braille.
struct PageName {
    std::string text;
    std::string key;  ///< two letters that stand for it at its place, the words being in the key; empty: the words stand there
    Point thing;      ///< what it names is there
    Rect place;       ///< of the words, or of the two letters
};

/// The scale bar: a line with a mark at each end, and what it stands for beside it.
struct PageScale {
    std::string text;   ///< "5 m"
    double length = 0;  ///< mm on the page
    double real = 0;    ///< mm in the world
    Rect place;         ///< of bar and words
};

/// Origin top left, y down, everything in mm and pure black.
struct Page {
    double width = 0;
    double height = 0;
    Rect live;  ///< the sheet within its margins
    std::vector<PageStroke> strokes;
    std::vector<Area> areas;  ///< black
    std::optional<Bitmap> picture;
    std::vector<BrailleLine> braille;
    double braille_dot = 0;  ///< diameter in mm
    CellSize cell = kMarburgMedium;
    std::optional<DotBed> bed;  ///< of the machine that it is for
    std::vector<PrintLine> print;
    std::string title;
    std::string caption;
    std::string braille_table;         ///< the liblouis table that the braille is in; empty = no braille was asked for
    std::string description;           ///< a person's words, one line; empty = none (description.h has our own)
    std::string language = "en";       ///< of the title and of those words
    std::vector<PageName> names = {};  ///< in reading order
    std::vector<Name> left_out = {};   ///< optional ones for which there was no room
    /// Where patterns are, for words and rules; they themselves are among the strokes. Each has a texture of 1 or more.
    std::vector<Area> textured = {};
    std::vector<Region> regions = {};  ///< as in the drawing
    std::vector<Phrase> remarks = {};  ///< as in the drawing
    bool is_key = false;               ///< nothing is drawn on it: its names say what the letters on the drawing stand for
    std::optional<PageScale> scale = {};
};

/// How wide a line of that class is drawn, mm.
double width_of(LineClass line, const Medium& medium);

/// Nothing is on it, to be felt or to be seen.
bool is_blank(const Page& page);
/// Nothing on it yet: of the same size, with the same braille, in the same language.
Page empty_like(const Page& page);
void move_by(Page& page, double right, double down);  ///< all that is on it, mm
double total_stroke_length(const Page& page);         ///< mm, without patterns

/// Centres of all raised dots of a line of braille.
std::vector<Point> dots_of(const BrailleLine& line, const CellSize& cell);

}  // namespace tactics
