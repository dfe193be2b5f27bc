// SPDX-License-Identifier: Apache-2.0
// Surfaces of revolution: cups, bottles, pots, lamp shades, wheels, as a hand knows them. The same profile all round an axis,
// however the file divides it into facets; a handle or a spout may interrupt it.
//
// The axis: the lines along the normals of a surface of revolution all meet it, a linear condition on its six Plücker coordinates
// (H. Pottmann, T. Randrup, "Rotational and helical surface approximation for reverse engineering", Computing 60, 1998). The
// proof: half-planes through the axis cut the same profile out of the surface in nearly all directions.
#pragma once

#include <optional>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/model.h"
#include "tactics/solid/solid.h"

namespace tactics {

/// A line in a half-plane through an axis: x away from the axis, y along it, mm. Closed ones do not repeat their first point.
struct ProfileLine {
    std::vector<Point> points;
    bool closed = false;
};

struct Revolution {
    /// An end along the axis.
    struct End {
        double radius = 0;  ///< mm: of the rim of a hollow, else of the disc that the surface ends in; 0: in a tip
        bool open = false;  ///< a hollow opens there
    };
    Point3 foot;        ///< on the axis, where the surface begins
    Point3 axis;        ///< of length 1, from there to where it ends
    double height = 0;  ///< mm
    double widest = 0;  ///< mm, the greatest radius, without a handle
    std::vector<ProfileLine> profile;
    End low, high;
    /// The direction of what interrupts it, such as a handle: of length 1, across the axis; zero: nothing does.
    Point3 handle = {};
    std::vector<ProfileLine> handled = {};  ///< the profile in that direction
    Primitive primitive = Primitive::none;  ///< that it is, if it is one
    /// It is closed at one end and open at the other.
    bool is_vessel() const { return low.open != high.open; }
    bool has_handle() const { return !handled.empty(); }
};

/// Nothing: it is none, or has fewer than ten facets round its axis, which a hand would tell one from the other.
std::optional<Revolution> revolution_of(const Solid& solid);
/// About the axis of another: that with its handle.
std::optional<Revolution> revolution_of(const Solid& solid, const Revolution& axis);

/// That of a cylinder or a cone with these of its ends, or of a sphere, which has no profile here.
Revolution revolution_of(Primitive primitive, const PrimitiveFrame& frame, bool has_low, bool has_high);

/// How far it reaches from the axis at a height, mm; 0: there is nothing.
double reach_at(const std::vector<ProfileLine>& profile, double height);

}  // namespace tactics
