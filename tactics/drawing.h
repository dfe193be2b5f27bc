// SPDX-License-Identifier: Apache-2.0
// A drawing in millimetres. Every source becomes one, and the page for every medium is laid out from it.
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

/// The importance of a line; the medium sets the width of each class (medium.h).
enum class LineClass : std::uint8_t { thin, normal, thick };

/// The purpose of a line: rules differ by role. Files from other programs do not state it.
enum class Role : std::uint8_t {
    line,     ///< a thing's outline or a curve: the subject of the drawing
    lead,     ///< from words to the thing that they name
    tick,     ///< across an axis, at a value
    dash,     ///< a dashed line, stored whole until repair; afterwards one of its dashes, stored in order one after another
    arrow,    ///< the arrow head at an end of a line
    symbol,   ///< a point symbol: its outline, or an area
    axis,     ///< of a chart
    grid,     ///< grid line, leads from a curve to an axis
    scale,    ///< the scale bar and its end marks
    pattern,  ///< a mark of an area's texture
    mark,     ///< marks where sheets of a large page meet
    dots,     ///< a dotted line, stored whole until repair makes a row of dots of it, each a dash
};
/// The drawing itself, without the additions inside or around it.
inline bool is_drawn(Role role) { return role < Role::scale || role == Role::dots; }
std::string_view name_of(Role role);     ///< "line", "lead", ...
Role role_named(std::string_view name);  ///< Role::line for any other word

/// A polyline. Closed strokes do not repeat the first point at the end.
struct Stroke {
    std::vector<Point> points;  ///< at least 2; a closed one at least 3
    bool closed = false;
    LineClass line = LineClass::normal;
    float strength = 0;  ///< importance; the strongest are kept first. From an edge map: strength in grey levels; else 0.
    Role role = Role::line;
};

/// Outer rings and holes together, filled by the even-odd rule. Rings do not repeat their first point.
struct Area {
    std::vector<std::vector<Point>> rings;
    Role role = Role::line;  ///< arrow, symbol, or line for an area of the drawing
    int texture = 0;         ///< 0: black; else the number of a texture (texture.h)
};

/// Words beside the thing they describe: in print, braille or both, as the sheet decides. Their size does not depend on the
/// scale.
struct Label {
    Point at;
    double across = 0;  ///< position of `at` in the words: 0 at their left end, 0.5 in the middle, 1 at the right end
    double down = 0;    ///< 0 at their top, 0.5 in the middle, 1 at the bottom
    std::string text;   ///< UTF-8, one line
};

/// The name of a thing in the drawing. Layout finds the place of the words on the page.
struct Name {
    Point at;                 ///< on the thing, or in its middle
    std::string text;         ///< UTF-8, one line
    std::string origin = {};  ///< where it came from, for messages: "--label 2", "map.labels:3"
    double within = 0;        ///< mm: up to this distance the name needs no lead line; 0: up to the distance at which a finger
                              ///< finds it
    bool optional = false;    ///< it is left out if there is no room, and the page says so
};

/// A thing that a drawing shows, for touch tablets and screen readers. It cannot be felt or seen.
struct Region {
    Phrase name;         ///< UTF-8, one line; never empty
    std::string path;    ///< its path, by which a user selects it: "Table/Top"; may be empty
    Phrase description;  ///< UTF-8, one line: how it is drawn, or why it is not; may be empty
    /// What was done with it, for programs: "folded", 3.
    std::vector<std::pair<std::string, int>> counts;
    /// Its area by the non-zero rule, so that its shapes may overlap: outer rings run one way, holes the other. Rings do not
    /// repeat their first point. No rings: it is not drawn.
    std::vector<std::vector<Point>> rings;
    Point at;  ///< a point well inside it; only if there are rings
};
bool holds(const Region& region, Point at);

/// How well people would agree with a drawing, as estimated by the filter that drew it: shares of length, 0 to 1.
struct Trust {
    double line = 0;   ///< share of its line that at least three of five people would have drawn
    double found = 0;  ///< share of their lines that it has

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
    /// In reading order, except that regions on top of others come after them. They may reach half a line width out of the
    /// drawing.
    std::vector<Region> regions = {};
    std::vector<Phrase> remarks = {};  ///< on the whole drawing, for its description: one sentence each
    std::optional<Trust> trust = {};   ///< nothing: no estimate
};

/// Scales the drawing to that width, the height in proportion: positions change, line widths do not.
Drawing scaled_to(Drawing drawing, double width);

double length_of(const Stroke& stroke);              ///< mm, with the closing side
double total_stroke_length(const Drawing& drawing);  ///< mm

}  // namespace tactics
