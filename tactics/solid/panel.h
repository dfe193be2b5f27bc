// SPDX-License-Identifier: Apache-2.0
// The parts of a model that can be drawn in their true shape: plane panels, hinges between them, and bars. M. Kurze, CHI 1997,
// steps 2 to 4.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/part.h"

namespace tactics {

/// The plane that a drawing is in, from the side that is read. Lengths 1.
struct ViewPlane {
    Point3 right, down, toward;  ///< toward: to the reader; down x right points there, too
};
inline constexpr double kAligned = 0.99985;  ///< cosine up to which two directions are one: 1 degree
inline constexpr double kLevel = 0.17;       ///< sine up to which something is as good as in the plane: 10 degrees

inline constexpr ViewPlane kFromAbove{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
inline constexpr ViewPlane kFromTheFront{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}};
inline constexpr ViewPlane kFromTheSide{{0, 1, 0}, {0, 0, -1}, {1, 0, 0}};

enum class PanelKind : std::uint8_t {
    side,     ///< a plane side, in its true shape
    cap,      ///< the end of something round
    opening,  ///< the end of something round that is not closed there
    outline,  ///< what something round or curved looks like from there
    section,  ///< what something round looks like from there if it is cut through its axis
    bottom,   ///< the closed end of a vessel: a hand that comes to its opening comes to it
    hanging,  ///< what something that a face hides looks like from the side
};

/// Whether it is a view of a whole part, of which one may do.
constexpr bool is_view(PanelKind kind) { return kind == PanelKind::outline || kind == PanelKind::section; }

/// A line on a panel that is no border of it.
struct PanelLine {
    std::vector<Point3> points;
    bool closed = false;
};

struct Panel {
    std::uint32_t part = 0;  ///< place in the list of parts
    PanelKind kind = PanelKind::side;
    Point3 normal;                               ///< outwards
    std::vector<std::vector<Point3>> rings;      ///< as those of a Patch
    double area = 0;                             ///< mm2
    bool reached = true;                         ///< a hand can lie on it
    std::vector<std::uint32_t> open_sides = {};  ///< of the first ring, that are no lines: a vessel is open there
    bool is_bordered = true;                     ///< off: its rings say where it is; only its lines are drawn
    std::vector<PanelLine> lines = {};
    std::uint32_t opening = 0;  ///< of a bottom: the place of its vessel's opening in Panels::panels
};

/// A connection of two panels. Their sides coincide, or would if both parts had no thickness.
struct Hinge {
    std::uint32_t one = 0, other = 0;  ///< places in Panels::panels
    Point3 one_from, one_to;           ///< as the one goes round it
    Point3 other_from, other_to;       ///< the same ends, on the other
    bool is_tangent = false;           ///< their borders meet in a point there, as a circle and a straight line do
};

/// A slender part by its axis, or a face by the edge that it turns to the reader.
struct Bar {
    std::uint32_t part = 0;
    Point3 held, loose;        ///< its ends; held: where it meets another part
    std::uint32_t holder = 0;  ///< the panel that it is held by, if `ends_held` is not 0
    int ends_held = 0;
    bool is_edge = false;  ///< of a face, for which it stands where the face itself finds no room
};

struct Panels {
    std::vector<Panel> panels;
    std::vector<Hinge> hinges;
    std::vector<Bar> bars;
};

/// The same, each part moved by that much.
Panels moved(Panels panels, const std::vector<Point3>& by);

Point3 middle_of(const Panel& panel);

}  // namespace tactics
