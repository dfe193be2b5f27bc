// SPDX-License-Identifier: Apache-2.0
// The point that stays on the surface while the finger sinks in: what a device with three degrees of freedom pulls towards.
#pragma once

#include "tactics/drawing.h"
#include "tactics/haptics/scenes/relief_surface.h"
#include "tactics/haptics/scenes/scene.h"

namespace tactics {

/// The god-object of C. B. Zilles and J. K. Salisbury (IROS 1995) over a height map. The surface is that of facets: each square
/// of four samples is cut in two from its left upper to its right lower corner. The proxy goes straight to the finger as far as
/// air reaches, then along the facets, never away from the finger, to where nothing near is nearer to it.
///
/// No sets of active planes are looked for. Above a facet lies a convex column, and the place in it that is nearest to the finger
/// is known in closed form; where it lies on the border, the columns that meet there are asked, and the nearest is moved into.
/// Where none is nearer the distance has its local minimum over the whole neighbourhood, on convex edges and corners as in
/// concave ones, and as every move is strictly nearer, it ends.
class Proxy {
public:
    explicit Proxy(const ReliefSurface& surface) noexcept;  ///< the surface must outlive it

    /// Where it is for the finger there; once per update. First of all, straight above or at the finger. A finger that is not
    /// finite changes nothing. Time is bounded: after kMostSteps it stops where it is, in air or on the surface, and goes on the
    /// next time.
    Point3 follow(Point3 finger) noexcept;
    bool settled() const noexcept { return settled_; }  ///< at the local minimum; else on its way
    void lift() noexcept { lifted_ = true; }            ///< the finger was taken off and is set down anew: forgets where it was
    double height(Point at) const noexcept;             ///< mm, of the facets; what follow() gives is never below it

    static constexpr int kMostSteps = 400;  ///< borders of facets in one update: 130 squares straight on

private:
    // In samples from the first one, heights too, so that squares are cubes' sides and borders are at whole numbers.
    struct Place {
        double u, v, w;
    };
    // Half of a square: the right upper one (across >= down), or the left lower one. Beside the map a strip or a quarter without
    // an end, of column -1 or the last, row -1 or the last, and whole.
    struct Facet {
        int column, row;
        bool lower;
    };
    enum class Border : unsigned char { none, edge, corner };
    // The nearest place in the column above a facet.
    struct Foot {
        Place place;
        double squared;  // its distance
        Border border;
        Facet beside;     // behind the edge; of a corner, its column and row
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
    double pitch_, per_mm_, lowest_, highest_;  // the heights in samples
    Place place_{};
    Facet facet_{};
    Point3 last_{};
    bool lifted_ = true, within_ = false, settled_ = true;  // within: on a facet, not at its border
};

}  // namespace tactics
