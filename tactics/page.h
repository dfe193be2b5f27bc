// SPDX-License-Identifier: Apache-2.0
// The page: a drawing on a sheet of a medium, fully resolved. Every output format draws this page and nothing else.
//
// lay_out guarantees that no position is off the paper; no line is thinner than the medium's thinnest; line classes, units and
// scale are resolved; text is translated into braille, and all text is one line of valid UTF-8 without control characters;
// nothing is grey; points of lines and areas lie on the steps of kPageStep.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/kind_heights.h"
#include "tactics/medium.h"

namespace tactics {

struct Rect {
    double left = 0, top = 0, width = 0, height = 0;  ///< mm

    Point middle() const { return {left + width / 2, top + height / 2}; }
    bool holds(Point p) const { return p.x >= left && p.x <= left + width && p.y >= top && p.y <= top + height; }
};

/// Where a machine can raise dots on its sheet. Its braille cells are those of the page.
struct DotBed {
    Point first;        ///< centre of the first dot, from the top left corner of the sheet
    double raster = 0;  ///< distance between dots all over the sheet, mm; 0: dots stand in cells only
    int dots_down = 3;  ///< of a cell; 4 with dots 7 and 8

    /// Distance from one possible start of a cell to the next, mm.
    double across(const CellSize& cell) const { return raster > 0 ? raster : cell.cell_pitch; }
    double down(const CellSize& cell) const { return raster > 0 ? raster : cell.line_pitch; }
    bool operator==(const DotBed& other) const {
        return first.x == other.first.x && first.y == other.first.y && raster == other.raster && dots_down == other.dots_down;
    }
};

/// A row of braille cells. Graphic formats draw its dots in mm; text formats write the cells.
struct BrailleLine {
    Point first_dot;                  ///< centre of dot 1 of the first cell
    std::vector<std::uint8_t> cells;  ///< bit 0 = dot 1 ... bit 5 = dot 6 (bits 6, 7 = dots 7, 8)
    int words = -1;                   ///< which of the page's words it sets; -1: nobody told
};

/// One line of print for sighted helpers.
struct PrintLine {
    Point baseline;   ///< left end
    double size = 0;  ///< letter size (em) in mm
    std::string text;
    int words = -1;  ///< as of BrailleLine
};

enum class WordsKind : std::uint8_t {
    title,
    caption,
    name,     ///< of a thing, beside it
    letters,  ///< two that stand for a name, beside its thing
    key,      ///< an entry of the key; without a line of its own on the page: the key has its own pages
    label,    ///< of the drawing, such as a number on an axis
    scale,    ///< what the scale bar stands for
    mark,     ///< which of several sheets it is
};
std::string_view name_of(WordsKind kind);                     ///< "title", "caption", ...
std::optional<WordsKind> words_named(std::string_view name);  ///< nothing for any other word

/// Words that are set on a page, in braille, in print or in both, for who sets them anew.
struct PageWords {
    WordsKind kind = WordsKind::label;
    std::string text;             ///< UTF-8, one line
    std::string key = {};         ///< of letters and key: the two letters
    Point at = {};                ///< of a label, mm; with `across` and `down` as Label has them
    double across = 0, down = 0;  ///< likewise
    double within = 0;            ///< of names and letters, as Name has it
    bool optional = false;        ///< likewise
};

struct PageStroke {
    std::vector<Point> points;
    bool closed = false;
    double width = 0;  ///< mm; round ends and joins
    Role role = Role::line;
    bool inner = false;  ///< a thin line of the drawing: a detail inside a thing, also where all lines are as wide
    bool heavy = false;  ///< of a figure: its style is felt as a thick line, however wide it is drawn
};
LineKind kind_of(const PageStroke& stroke);
/// What becomes of a line of the drawing.
inline bool is_inner(const Stroke& stroke) { return stroke.role == Role::line && stroke.line == LineClass::thin; }

/// A black-and-white picture: 1 bit per pixel, rows padded to bytes, most significant bit left, 1 = black.
struct Bitmap {
    int width = 0;
    int height = 0;
    Rect place;  ///< mm
    std::vector<std::uint8_t> bits;
    std::size_t row_bytes() const { return (static_cast<std::size_t>(width) + 7) / 8; }
};

/// Converts a grey picture: pixels darker than mid-grey become black.
Bitmap to_bitmap(const Image& grey, const Rect& place);

/// The name of a thing in the drawing, as it was placed; its cells are in the page's braille.
struct PageName {
    std::string text;
    std::string key;  ///< two letters that stand in its place if the words are in the key; empty: the words stand there
    Point thing;      ///< a point on the named thing
    Rect place;       ///< box of the words, or of the two letters
    int words = -1;   ///< as in BrailleLine
};

/// The scale bar: a line with a mark at each end, with the length that it represents beside it.
struct PageScale {
    std::string text;   ///< "5 m"
    double length = 0;  ///< mm on the page
    double real = 0;    ///< mm in the world
    Rect place;         ///< box of bar and words
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
    std::optional<DotBed> bed;  ///< of the machine that the page is for
    KindHeights heights = {};   ///< of its lines there, the same on all pages of a drawing
    std::vector<PrintLine> print;
    std::string title;
    std::string caption;
    std::string braille_table;         ///< the liblouis table of the braille; empty = no braille was requested
    std::string description;           ///< description by a person, one line; empty = none (description.h makes our own)
    std::string language = "en";       ///< language of the title and of that description
    std::vector<PageName> names = {};  ///< in reading order
    std::vector<Name> left_out = {};   ///< optional names that had no room
    /// The areas that have patterns, for descriptions and rules; the patterns themselves are among the strokes. Each has a
    /// texture of 1 or more.
    std::vector<Area> textured = {};
    std::vector<Region> regions = {};  ///< as in the drawing
    std::vector<Phrase> remarks = {};  ///< as in the drawing
    bool is_key = false;               ///< a page without a drawing: its names explain the letters on the drawing
    std::optional<PageScale> scale = {};
    std::vector<PageWords> words = {};
    std::string medium = {};  ///< its name; empty: nobody told
    Rect drawing = {};        ///< where the drawing lies; of no width: there is none
};

/// Points of lines and areas, and widths, are integer multiples of this, so a file that writes them so holds the page itself.
inline constexpr double kPageStep = 0.01;  // mm
/// Moves them there, by half a step at most, and drops points that then coincide with the one before, and rings left with fewer
/// than three points; a line of no length keeps two.
void put_on_steps(Page& page);
Point on_steps(Point p);
std::vector<Point> on_steps(const std::vector<Point>& points);

/// Drops words that no line sets, except those of a key.
void drop_unset_words(Page& page);

/// Width of a line of that class, mm.
double width_of(LineClass line, const Medium& medium);

/// Whether nothing is on it, to be felt or seen.
bool is_blank(const Page& page);
/// An empty page with the same size, braille and language.
Page empty_like(const Page& page);
void move_by(Page& page, double right, double down);  ///< moves everything on it, mm
double total_stroke_length(const Page& page);         ///< mm, without patterns

/// Centres of all raised dots of a line of braille.
std::vector<Point> dots_of(const BrailleLine& line, const CellSize& cell);

}  // namespace tactics
