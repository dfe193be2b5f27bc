// SPDX-License-Identifier: Apache-2.0
// The sides of a shape must be long enough for its form to be known.
#include <algorithm>
#include <limits>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

constexpr double kSideLengthStraight = 0.25;  // mm that a straight side may bow out
constexpr std::size_t kMostCorners = 8;       // a shape with more is round
// To a fingertip, which resolves 1 mm (25 dpi) at best, a shorter side is a rounded or cut-off corner.
constexpr double kCorner = 2.5;

// Corners of a closed line by Douglas and Peucker's division; empty if there are more than kMostCorners.
class Corners {
public:
    Corners(const std::vector<Point>& points, double straight) : points_(points), straight_(straight) {}

    std::vector<Point> find() {
        const std::size_t start = farthest_from(points_[0]), across = farthest_from(points_[start]);
        if (start == across) return {};
        divide(start, across);
        divide(across, start);
        if (divisions_ > kMostCorners - 2) return {};
        std::vector<Point> corners;
        for (const std::size_t i : found_) corners.push_back(points_[i]);
        return corners;
    }

private:
    std::size_t farthest_from(Point p) const {
        return static_cast<std::size_t>(
            std::max_element(points_.begin(), points_.end(), [p](Point a, Point b) { return distance(a, p) < distance(b, p); }) -
            points_.begin());
    }
    // Adds the corners from `from` up to, but without, `to`, going round.
    void divide(std::size_t from, std::size_t to) {
        const std::size_t n = points_.size();
        const Segment chord{points_[from], points_[to]};
        double most = straight_;
        std::size_t at = to;
        for (std::size_t i = (from + 1) % n; i != to; i = (i + 1) % n) {
            const double off = distance(points_[i], nearest_on(chord, points_[i]));
            if (off > most) {
                most = off;
                at = i;
            }
        }
        if (at == to) {
            found_.push_back(from);
            return;
        }
        if (++divisions_ > kMostCorners - 2) return;  // the two that it starts from are corners, too
        divide(from, at);
        divide(at, to);
    }

    const std::vector<Point>& points_;
    double straight_;
    std::vector<std::size_t> found_;
    std::size_t divisions_ = 0;
};

struct Side {
    double length = 0;
    Point middle;
};

// The shortest side of a shape with straight sides; nothing if it is round or so small that it has no sides.
std::optional<Side> shortest_side(const std::vector<Point>& points, double extent) {
    const auto corners = Corners(points, std::min(kSideLengthStraight, extent / 50)).find();
    if (corners.size() < 3) return std::nullopt;
    std::optional<Side> shortest;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point a = corners[i], b = corners[(i + 1) % corners.size()];
        const double length = distance(a, b);
        if (length >= kCorner && (!shortest || length < shortest->length))
            shortest = {length, {(a.x + b.x) / 2, (a.y + b.y) / 2}};
    }
    return shortest;
}

Findings check_side_length(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (std::uint32_t c = 0; c < geometry.chains.size(); ++c) {
        const Chain& chain = geometry.chains[c];
        if (geometry.role_of(chain) != Role::line) continue;  // point symbols and arrow heads have rules of their own
        if (!chain.closed || (chain.ring && geometry.is_hole(chain))) continue;
        if (chain.ring && geometry.figures[geometry.figure_of[c]].size() > 1)
            continue;  // its outline, or a line that ends in it, counts
        const std::vector<Point> points = geometry.points_of(chain);
        const double extent = geometry.extent_of({c}, std::numeric_limits<double>::max()) - 2 * chain.half_width;
        if (const auto side = shortest_side(points, extent)) {
            if (side->length < limit - kRounding)
                findings.places.push_back(
                    {side->length, side->middle, {}, phrase("a side of {0} mm in a shape", shown(side->length))});
        } else if (extent < limit - kRounding) {
            findings.places.push_back({extent, points[0], {}, phrase("a shape {0} mm across", shown(extent))});
        }
    }
    return findings;
}

}  // namespace

extern const Rule side_length_rule;
const Rule side_length_rule{
    .name = "side-length",
    .summary = "sides of closed shapes long enough for the shape to be recognised",
    .mend = "draw it larger, or use a point symbol with a key",
    .source =
        "APH guide: shapes with sides under 1/2 in may not be recognised. Shapes of up to 8 straight sides are measured by their "
        "shortest side, rounder ones across",
    .confidence = Confidence::good,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 12.7,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum length of a side"},
    .check = check_side_length,
};

}  // namespace tactics
