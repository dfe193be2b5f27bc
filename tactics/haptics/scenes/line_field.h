// SPDX-License-Identifier: Apache-2.0
// Distance and direction from a finger to the lines of a plot, smooth enough to be felt, at a cost that does not depend on the
// number of lines.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/haptics/scenes/line_squares.h"
#include "tactics/point3.h"

namespace tactics {

/// Polylines in the plane z = 0, felt from anywhere in space. The distance to the nearest point of all lines has edges where two
/// points are equally near and the direction jumps: inside corners, between two curves, everywhere in noise. These edges are
/// rounded: the distance is opened by a paraboloid that falls by 1 in `blend` / 2 mm (J. Serra, Image Analysis and Mathematical
/// Morphology, 1982; two Moreau envelopes), which bounds how fast the direction can turn. Places without an edge keep their
/// distance; no distance grows, and none shrinks by more than `blend` / 4.
///
/// The squared distance is computed at the nodes of a grid and interpolated by quadratic splines, which reproduce a square
/// exactly: beside a straight line the distance is exact and the force is perpendicular to it. Within two nodes of a line the
/// distance is too large by up to about half a pitch, which keeps the slope continuous there. The slope is exactly that of the
/// distance, so a force that depends on the distance alone has a potential, and no closed path gains energy, however many lines
/// there are.
class LineField {
public:
    struct Reach {
        double far = 10;     ///< mm; beyond it there is no result
        double blend = 1.5;  ///< mm
    };
    static constexpr double kPitch = 0.1;  ///< mm between nodes: a third of the core of the narrowest fixture (fixture.h)
    /// If there would be more, as for curves of 200 x 200 mm, the nodes are farther apart.
    static constexpr std::size_t kMostNodes = 4'000'000;

    /// Lines of one point have no segments; points must be finite.
    LineField(const std::vector<std::vector<Point>>& lines, const Reach& reach);

    struct Felt {
        double distance = 0;  ///< mm
        Point3 slope;         ///< gradient of the distance; of length 1 where one line is near and no edge
        bool within = false;  ///< false: no line is within reach, and the other members are invalid
    };
    Felt at(const Point3& place) const noexcept;

    double pitch() const noexcept { return squares_.side; }

private:
    void round_edges(std::vector<float>& distances, double blend) const;
    void take_squares(const std::vector<float>& distances);

    double far_;
    LineSquares squares_;         // the nodes are the middles of the squares
    std::vector<float> weights_;  // of the splines, mm^2
};

}  // namespace tactics
