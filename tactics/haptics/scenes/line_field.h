// SPDX-License-Identifier: Apache-2.0
// How far a finger is from the lines of a plot, and which way: a distance that can be felt, at a cost that does not depend on
// them.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/haptics/scenes/line_squares.h"
#include "tactics/point3.h"

namespace tactics {

/// Polylines in the plane z = 0, felt from anywhere in space. The distance to the nearest place of all lines has edges, where two
/// are equally near and the direction to the nearest jumps: at the inside of a corner, between two curves, everywhere in noise.
/// These edges are rounded: the distance is opened by a paraboloid that falls by 1 in `blend` / 2 mm (J. Serra, Image Analysis
/// and Mathematical Morphology, 1982; two Moreau envelopes), so that nothing turns more quickly than that. What has no edge stays
/// as it is, nothing becomes farther, and nothing nearer by more than `blend` / 4.
///
/// It is worked out at the nodes of a grid, squared there, and read between them by quadratic splines, which have a square as it
/// is: beside a straight line the distance is exact, and the force wholly across. Within two nodes of a line it is too far by up
/// to about half a pitch, so that even there the slope is continuous. The slope is exactly the distance's: a force that depends
/// on the distance alone has a potential, and no way round gains energy, however many lines there are.
class LineField {
public:
    struct Reach {
        double far = 10;     ///< mm; beyond, nothing is told
        double blend = 1.5;  ///< mm
    };
    static constexpr double kPitch = 0.1;  ///< mm between nodes: a third of the core of the narrowest fixture (fixture.h)
    /// Where there would be more, as for curves of 200 x 200 mm, nodes are farther apart.
    static constexpr std::size_t kMostNodes = 4'000'000;

    /// Lines of one point have none; places must be finite.
    LineField(const std::vector<std::vector<Point>>& lines, const Reach& reach);

    struct Felt {
        double distance = 0;  ///< mm
        Point3 slope;         ///< how it grows with the place; of length 1 where one line is near and no edge
        bool within = false;  ///< false: no line is within reach, and nothing is told
    };
    Felt at(const Point3& place) const noexcept;

    double pitch() const noexcept { return squares_.side; }

private:
    void round_edges(std::vector<float>& distances, double blend) const;
    void take_squares(const std::vector<float>& distances);

    double far_;
    LineSquares squares_;         // the nodes are their middles
    std::vector<float> weights_;  // of the splines, mm^2
};

}  // namespace tactics
