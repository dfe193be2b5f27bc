// SPDX-License-Identifier: Apache-2.0
// What a shape of SVG is painted with: presentation attributes, style attributes and simple style sheets.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/xml.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// 0 is black, 1 is white, on white paper. Nothing for what is no colour.
std::optional<double> lightness_of(std::string_view colour);

/// What a drawing has that a page has not, counted: it is told, not passed over.
struct Missed {
    std::size_t letters = 0;    ///< texts
    std::size_t dashes = 0;     ///< too fine, taken for whole lines
    std::size_t clips = 0;      ///< clip paths and masks that are not applied
    std::size_t textures = 0;   ///< patterns and gradients taken for black
    std::size_t markers = 0;    ///< along lines, or not found
    std::size_t pictures = 0;   ///< beyond the one that a page can have, turned, outside the file, or of another format
    std::size_t stretched = 0;  ///< lines wider in one direction
    std::size_t colours = 0;    ///< not known, taken for black
    std::size_t selectors = 0;  ///< of style sheets, not understood
    std::size_t pale = 0;       ///< lines and surfaces too light for a figure
    std::size_t foreign = 0;    ///< elements of other languages
    std::size_t shadows = 0;    ///< of a figure
    std::size_t broken = 0;     ///< paths of a figure that are drawn up to a fault
    std::size_t pages = 0;      ///< that the file has; one is looked at
    bool all = false;           ///< nothing of a page is to be felt
};

/// "2 texts or letters are not looked at by any rule", and so on; nothing for what is none.
std::vector<Phrase> notes_of(const Missed& missed, bool figure);

struct Paint {
    bool none = false;
    double lightness = 0;
    double opacity = 1;
    bool fades = false;                                                        ///< into nothing, as shadows do
    double pattern = 0;                                                        ///< tells a pattern from others; 0: none
    double shown() const { return none ? 1 : 1 - opacity * (1 - lightness); }  ///< on white
    /// What is darker than half grey is raised.
    bool is_ink() const { return shown() < 0.5; }
    /// It is no paper.
    bool is_seen() const { return shown() < 0.95; }
};

/// A surface without a line that is mostly clear and fades, or is blurred: a shadow or a gleam, which is no part of the drawing.
bool is_shadow(const Paint& fill, const Paint& stroke, bool blurred);

/// The paints of a shape of a figure, in black or not at all: a surface that is not white and has no line around it gets one;
/// what is as small as a mark of a plot (`size` in mm) stays full. True: it was too pale for either.
bool paint_figure(Paint& fill, Paint& stroke, bool has_inside, double size);

/// What an element hands down to those in it.
struct Style {
    Paint fill;
    Paint stroke{true, 0, 1};
    double current = 0;  ///< lightness of currentColor
    std::string stroke_width = "1";
    bool butt = true;  ///< ends of lines are cut off at their points
    bool even_odd = false;
    std::string dashes;  ///< empty or none: a whole line
    std::string dash_offset;
    double font_size = 16;                 ///< px, as CSS has it where nothing is told ("medium")
    std::string font_family;               ///< as it is told: names, the most wanted first
    std::string anchor = "start";          ///< of texts
    std::string marker_start, marker_end;  ///< "url(#name)"
    bool visible = true;
    double opacity = 1;  ///< of all groups around it
    bool shown = true;   ///< display is not none
    bool blurred = false;
    double fill_own = 1, stroke_own = 1;  ///< opacity of the gradients they are painted with
    const Element* of = nullptr;          ///< whose style it is
    const Style* outer = nullptr;         ///< of the element around that; nullptr: there is none
};

/// "url(#name)" or "url('#name')", maybe with a colour behind it for those who do not know it: name. Empty for anything else.
std::string_view name_in_url(std::string_view url);

/// "a: b; c: d".
using Declarations = std::vector<std::pair<std::string, std::string>>;
Declarations parse_declarations(std::string_view text);

/// What gradients look like as a whole, and which patterns are the same, by their ids.
struct MeanPaint {
    double lightness = 0;
    double opacity = 1;
    bool fades = false;  ///< as shadows do: it is clear at its rim, or at one end and nowhere full
    double pattern = 0;  ///< its number, as in Paint (svg_pattern.h)
};
using MeanPaints = std::map<std::string, MeanPaint, std::less<>>;

/// Anything but the colour that currentColor is.
void set_property(Style& style, std::string_view name, std::string_view value, const MeanPaints& gradients, Missed& missed);

}  // namespace tactics
