// SPDX-License-Identifier: Apache-2.0
// A page that a file holds, with what the file tells of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tactics/layout/felt_bars.h"
#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A letter as a shape, as the file has it for all places where it stands.
struct LetterShape {
    std::string font;                       ///< what letters of one font and size have in common in the file
    std::vector<std::vector<Point>> rings;  ///< in units of its own, down, from where it stands on its line; none: a blank
    char32_t code = 0;                      ///< if the file says which letter it is
    bool inked = false;                     ///< the file does not tell where it begins: its ink begins at 0
    bool lone = false;                      ///< nor where its line is: it stands by itself
    bool adopted = false;                   ///< drawn by itself, as the font has no such letter (CairoGlyphs::adopt_shapes)
};

/// One of these in a line of letters.
struct DrawnLetter {
    std::size_t shape = 0;  ///< in the page's letter_shapes
    double at = 0;          ///< in the shape's units, along the line
    double up = 0;          ///< the same, across it: of an exponent or an index
};

/// Where words begin and end on the line that they stand on, as their font tells it; mm on the page.
struct TextRun {
    Point start, end;
    double em = 0;
};

/// Letters of the file, as far as it tells what they say.
struct FoundWords {
    std::string text;   ///< UTF-8; empty: they are drawn as shapes, and nobody has read them
    Point middle;       ///< mm on the page
    double height = 0;  ///< of the letters, mm
    bool upwards = false;
    double width = 0;                 ///< along the line, mm
    std::optional<Point> thing = {};  ///< what they name is there; nothing: it is where they stand
    std::vector<DrawnLetter> letters = {};
    Point start = {}, way = {1, 0};   ///< of the line of letters, mm, and where it goes: 1 mm along it
    double unit = 0;                  ///< mm for one of the shapes' units
    double sureness = 100;            ///< of 100: less if they were read as print is
    bool centred = false;             ///< the file sets them by their middle
    bool hidden = false;              ///< they lie behind something that is drawn
    std::optional<TextRun> run = {};  ///< of text in a font of the file
    bool seen = false;                ///< a reader of print took them for letters, without being sure of which
};

/// A picture of pixels that stands upright within a figure.
struct FoundPicture {
    std::string bytes;                           ///< a file: PNG, JPEG or WebP
    Rect place;                                  ///< mm on the page
    Rect shown;                                  ///< mm; what clips leave of it
    bool mirrored = false, upside_down = false;  ///< it stands so in the figure
};

/// Of a dashed line.
enum class DashMarks : std::uint8_t { none, dashes, dots, both };

/// How one element of a figure is painted, and which strokes and areas of the page are its.
struct FoundLook {
    std::size_t stroke = 0, strokes_end = 0, area = 0, areas_end = 0;
    double line = -1, fill = -1;  ///< lightness, which tells colours of one figure apart; -1: none; over 1: a pattern
    std::size_t dashes = 0;       ///< in the page's dash_kinds; 0: a whole line
    DashMarks marks = DashMarks::none;
};

/// An opaque surface of a figure: what was drawn before it and lies behind it is not seen.
struct FoundCover {
    std::vector<std::vector<Point>> rings;
    std::size_t strokes, areas, words;  ///< so many there were of each before it
};

/// A page that was not laid out here: positions may lie off the paper, lines may be thinner than any medium's.
struct FoundPage {
    Page page;
    /// What the file has and the page has not, or has in another way: "2 texts are letters, which no rule looks at".
    std::vector<Phrase> notes;
    std::vector<FoundWords> words = {};
    std::vector<LetterShape> letter_shapes = {};
    std::vector<FoundLook> looks = {};    ///< of a figure
    std::vector<FoundCover> covers = {};  ///< of a figure
    /// Of a figure: rings of each shape no larger than letters that is as light as paper, and so not drawn.
    std::vector<std::vector<std::vector<Point>>> light_shapes = {};
    /// Of a figure, mm on the page; their outlines are among its lines, too.
    std::optional<ChartBars> bars = {};
    std::vector<FoundPicture> pictures = {};  ///< of a figure; that of a page is in its `picture`
    bool tells_size = true;                   ///< in mm, cm, in or pt; pixels are for screens
    /// mm, as the file has it, with 96 pixels to the inch. The page of a figure is 200 mm wide or high.
    double file_width = 0, file_height = 0;
    std::map<std::string, std::size_t> dash_kinds = {};  ///< a number for each, from 1: as the file has it, which may be long
};

}  // namespace tactics
