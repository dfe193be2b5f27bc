// SPDX-License-Identifier: Apache-2.0
// How far a finger is from the lines of a plot, and which way, at a cost that does not grow with them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/point3.h"

namespace tactics {

/// Of a place beside lines.
struct Nearness {
    double distance = 0;      ///< mm, blended
    Point3 slope;             ///< how it grows with the place: away from the line, of length 1 where only one is near
    std::uint32_t line = 0;   ///< the nearest one
    std::uint32_t index = 0;  ///< of its point before the nearest place
    Point place;              ///< the nearest place itself
    bool within = false;      ///< no line is within reach, and nothing of the above is told
};

/// Polylines in the plane z = 0, felt from anywhere in space. The distance is that to the nearest place of all lines, so that it
/// is continuous across vertices. Where two places are almost equally near (at the inside of a corner, between two curves) the
/// direction turns from one to the other over `blend` mm instead of at once: in the plane, the distance is the quadratic smooth
/// minimum of both (I. Quilez, "smooth minimum"). Its width shrinks towards a corner with the height of the saddle between the
/// two, so that what has just begun to be a nearest place of its own weighs nothing yet. The slope is exactly the distance's: a
/// force that depends on the distance alone has a potential, and no way round gains energy. Only two places are blended: in the
/// middle of a round bend the direction turns as quickly as the nearest place runs round, in steps of at most a 25th of the pull,
/// and where another line is as near as both, it can jump by a quarter.
///
/// For every cell of a grid it is worked out beforehand which segments can matter there. Nothing allocates in a query.
class NearLines {
public:
    struct Reach {
        double far = 10;     ///< mm; beyond, nothing is told
        double blend = 1.5;  ///< mm
    };
    /// Lines of one point have none; places must be finite.
    NearLines(const std::vector<std::vector<Point>>& lines, const Reach& reach);

    Nearness at(const Point3& place) const noexcept;
    std::size_t segments() const noexcept { return segments_.size(); }

private:
    struct Segment {
        Point from, way;  // its direction, of length 1
        double length;
        std::uint32_t line, index;
        bool goes_on;  // the next segment begins where it ends
    };
    // A place that is nearer than all beside it on its line.
    struct Foot {
        double distance;
        Point slope;
        std::uint32_t segment;
        double along;
        double saddle;  // the square of the farthest that the line goes between the foot before it and this; infinite: they do
                        // not hang together
        Point top;      // where that is
    };
    static constexpr std::size_t kMostFeet = 3;

    struct Found {
        std::uint32_t segment;
        double distance;  // from the middle of a cell
    };
    void lay_cells();
    void sort_into_cells();
    bool goes_far(std::uint32_t first, std::uint32_t last, Point middle, double most) const noexcept;
    double second_foot(const std::vector<Found>& found, Point middle, double half) const noexcept;
    double distance_to(const Segment& segment, Point place) const noexcept;
    static void drop_farthest(Foot* feet, std::size_t& count, double& saddle, Point& top) noexcept;
    std::size_t feet_at(Point place, Foot* feet) const noexcept;
    Nearness blended(Point place, const Foot* feet, std::size_t count) const noexcept;

    std::vector<Segment> segments_;
    double blend_, far_;
    Point corner_;  // of the first cell
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<std::uint32_t> starts_, entries_;
};

}  // namespace tactics
