// SPDX-License-Identifier: Apache-2.0
// The point that stays on the surface while the finger sinks in; a device with three degrees of freedom pulls towards it.
#pragma once

#include "tactics/drawing.h"
#include "tactics/haptics/scenes/relief_surface.h"
#include "tactics/haptics/scenes/scene.h"

namespace tactics {

/// The god-object of C. B. Zilles and J. K. Salisbury (IROS 1995) over a height map. The surface consists of facets: each square
/// of four samples is cut in two from its upper left to its lower right corner. The proxy moves straight towards the finger as
/// far as air reaches, then along the facets, never away from the finger, until no nearby point is nearer.
///
/// There is no search for sets of active planes. Above each facet lies a convex column, and its nearest point to the finger has a
/// closed form. If that point lies on the border, the columns that meet there are tried, and the proxy moves into the nearest. If
/// none is nearer, the distance has a local minimum over the whole neighbourhood, at convex and concave edges and corners alike;
/// every move is strictly nearer, so the search ends.
class Proxy {
public:
    explicit Proxy(const ReliefSurface& surface) noexcept;  ///< the surface must outlive it

    /// The proxy's position for that finger; call it once per update. At first it is straight above or at the finger. A finger
    /// that is not finite changes nothing. Time is bounded: after kMostSteps the proxy stops, in air or on the surface, and
    /// continues at the next update.
    Point3 follow(Point3 finger) noexcept;
    bool settled() const noexcept { return settled_; }  ///< at the local minimum; false: still moving
    void lift() noexcept { lifted_ = true; }            ///< the finger was lifted and set down anew: forgets the position
    double height(Point at) const noexcept;             ///< height of the facets, mm; the result of follow() is never below it

    static constexpr int kMostSteps = 400;  ///< facet borders in one update: 130 squares in a straight line

private:
    // In units of samples from the first one, including heights, so that squares have sides of 1 and borders are at whole
    // numbers.
    struct Place {
        double u, v, w;
    };
    // Half of a square: the upper right one (across >= down), or the lower left one. Beside the map, an infinite strip or
    // quadrant with column -1 or the last, or row -1 or the last, undivided.
    struct Facet {
        int column, row;
        bool lower;
    };
    enum class Border : unsigned char { none, edge, corner };
    // The nearest point in the column above a facet.
    struct Foot {
        Place place;
        double squared;  // its distance
        Border border;
        Facet beside;     // facet beyond the edge; for a corner, its column and row
        int column, row;  // of an edge: the corner behind it
        bool in_air;
    };

    double sample(int column, int row) const noexcept;
    bool on_map(const Facet& facet) const noexcept;
    Facet facet_at(double u, double v) const noexcept;
    double height_in(const Facet& facet, double u, double v) const noexcept;
    static void set_border(Foot& foot, int edge, double part) noexcept;
    Foot nearest(const Facet& facet, const Place& finger) const noexcept;
    Foot nearest_beside(const Facet& facet, const Place& finger) const noexcept;
    bool march(const Place& finger, int& steps) noexcept;
    bool settle(const Place& finger, int& steps) noexcept;
    bool leads_down(const Place& finger, int column, int row) const noexcept;
    bool nearer(const Facet& facet, const Place& finger, Foot& best) noexcept;
    bool nearer_around(int column, int row, const Place& finger, Foot& best, int& steps) noexcept;

    const ReliefSurface* surface_;
    const float* heights_;
    int last_column_, last_row_;
    double pitch_, per_mm_, lowest_, highest_;  // lengths and heights in units of samples
    Place place_{};
    Facet facet_{};
    Point3 last_{};
    bool lifted_ = true, within_ = false, settled_ = true;  // within: on a facet, not at its border
};

}  // namespace tactics
