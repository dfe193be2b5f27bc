// SPDX-License-Identifier: Apache-2.0
// A drawing in millimetres: what every source becomes and every medium is laid out from.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/image.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Millimetres, origin at the top left, y down.
struct Point {
    double x = 0;
    double y = 0;
};

inline double distance(Point a, Point b) { return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)); }

/// What a line is for; the medium says how wide each is (medium.h).
enum class LineClass : std::uint8_t { thin, normal, thick };

/// What a line is there for: rules ask different things of each. A file of another maker does not say.
enum class Role : std::uint8_t {
    line,  ///< a thing's outline, a curve: what the drawing is about
    lead,  ///< from words to what they name
    tick,  ///< across an axis, at a value
    dash,  ///< a dashed line, whole until it is repaired; then one of its dashes, which stand one behind the other in their order
    arrow,    ///< the head at an end of a line
    symbol,   ///< marks a point: the outline of one, or an area that is one
    axis,     ///< of a chart
    grid,     ///< helps the eye from a curve to an axis
    scale,    ///< the scale bar and its end marks
    pattern,  ///< a mark of what an area is filled with
    mark,     ///< where sheets of a large page meet
};
/// The drawing itself, not what is laid into it or around it.
inline bool is_drawn(Role role) { return role < Role::scale; }
std::string_view name_of(Role role);     ///< "line", "lead", ...
Role role_named(std::string_view name);  ///< Role::line for any other word

/// A polyline. Closed strokes do not repeat the first point at the end.
struct Stroke {
    std::vector<Point> points;  ///< at least 2; a closed one at least 3
    bool closed = false;
    LineClass line = LineClass::normal;
    float strength = 0;  ///< importance; larger is kept first. From an edge map: its strength in grey levels; else 0.
    Role role = Role::line;
};

/// Outer rings and holes together, filled by the even-odd rule. Rings do not repeat their first point.
struct Area {
    std::vector<std::vector<Point>> rings;
    Role role = Role::line;  ///< arrow, symbol; line: an area of the drawing
    int texture = 0;         ///< 0: black; else the pattern of that number (texture.h)
};

/// Words beside what they are about: print, braille or both, as the sheet has it. They keep their size whatever the scale.
struct Label {
    Point at;
    double across = 0;  ///< where `at` is in the words: 0 at their left end, 0.5 in the middle, 1 at the right end
    double down = 0;    ///< 0 at their top, 0.5 in the middle, 1 at the bottom
    std::string text;   ///< UTF-8, one line
};

/// What a thing in the drawing is called. Where the word stands, on the page, is found when it is laid out.
struct Name {
    Point at;                 ///< on the thing, or in its middle
    std::string text;         ///< UTF-8, one line
    std::string origin = {};  ///< where it came from, for messages: "--label 2", "map.labels:3"
    double within = 0;        ///< mm: so far from its place no line needs to lead there; 0: as far as a finger finds it
    bool optional = false;    ///< without room it is left out, and the page says so
};

/// A thing that a drawing shows, for who points at it or has it read out: nothing of it is felt or seen.
struct Region {
    Phrase name;         ///< UTF-8, one line; never empty
    std::string path;    ///< what it is asked for by: "Table/Top"; may be empty
    Phrase description;  ///< UTF-8, one line: how it is drawn, or why it is not; may be empty
    /// What was done with it, for programs: "folded", 3.
    std::vector<std::pair<std::string, int>> counts;
    /// Where it lies, by the non-zero rule, so that its shapes may lie over each other: outer rings run the same way, holes the
    /// other way. Rings do not repeat their first point. None: it is not drawn.
    std::vector<std::vector<Point>> rings;
    Point at;  ///< within, well off its border; only where there are rings
};
bool holds(const Region& region, Point at);

/// How well people would agree with a drawing, as far as who drew it can tell: shares of length, 0 to 1.
struct Trust {
    double line = 0;   ///< of its line, what at least three of five people would have drawn
    double found = 0;  ///< of what they would have drawn, what is in it

    double agreement() const { return line + found > 0 ? 2 * line * found / (line + found) : 0; }  ///< their harmonic mean
};

/// Strokes and areas lie within [0,width] x [0,height] up to half a line width.
struct Drawing {
    double width = 0;   ///< mm
    double height = 0;  ///< mm
    std::vector<Stroke> strokes;
    std::vector<Area> areas;
    /// A black-and-white picture (0 or 255) under the lines, for recipes that do not trace; covers the whole drawing.
    std::optional<Image> picture;
    std::vector<Label> labels = {};
    std::vector<Name> names = {};
    /// In reading order, but what lies on others behind them. They may reach half a line width out of the drawing.
    std::vector<Region> regions = {};
    std::vector<Phrase> remarks = {};  ///< on all of it, for who has it described: a sentence each
    std::optional<Trust> trust = {};   ///< nothing: who drew it cannot tell
};

/// As wide as that, its height in proportion: places change, widths of lines do not.
Drawing scaled_to(Drawing drawing, double width);

double length_of(const Stroke& stroke);              ///< mm, with the closing side
double total_stroke_length(const Drawing& drawing);  ///< mm

}  // namespace tactics
