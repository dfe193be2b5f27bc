// SPDX-License-Identifier: Apache-2.0
#include "filters/region_borders.h"

#include <algorithm>
#include <unordered_map>

#include "filters/smooth.h"
#include "tactics/geometry/course.h"

namespace tactics {

namespace {

// Directions: 0 up, 1 right, 2 down, 3 left. A corner (x, y) has pixel (x, y) to its lower right.
constexpr int kX[] = {0, 1, 0, -1}, kY[] = {-1, 0, 1, 0};
// The pixels to the left and right in front of one who stands on a corner and looks that way.
constexpr int kLeftX[] = {-1, 0, 0, -1}, kLeftY[] = {-1, -1, 0, 0};
constexpr int kRightX[] = {0, 0, -1, -1}, kRightY[] = {-1, 0, 0, -1};

struct Step {
    int x, y;  // the corner that it begins at
    int direction;

    Step back() const { return {x + kX[direction], y + kY[direction], (direction + 2) & 3}; }
};

class Tracer {
public:
    Tracer(const RegionMap& map, double tolerance) : map_(map), tolerance_(tolerance), seen_(4 * corners(), false) {}

    RegionBorders trace() {
        for (int y = 0; y < map_.height; ++y)
            for (int x = 0; x < map_.width; ++x)
                // A ring of this pixel's region runs up its left side or down its right side.
                for (const Step& step : {Step{x, y + 1, 0}, Step{x + 1, y, 2}})
                    if (!seen_[key(step)] && left_of(step) != right_of(step)) add_ring(step);
        return std::move(found_);
    }

private:
    std::size_t corners() const { return static_cast<std::size_t>(map_.width + 1) * static_cast<std::size_t>(map_.height + 1); }
    std::size_t key(const Step& s) const {
        return 4 * (static_cast<std::size_t>(s.y) * static_cast<std::size_t>(map_.width + 1) + static_cast<std::size_t>(s.x)) +
               static_cast<std::size_t>(s.direction);
    }
    std::int64_t region_at(int x, int y) const {
        return x < 0 || y < 0 || x >= map_.width || y >= map_.height ? -1 : std::int64_t{map_.region[map_.index(x, y)]};
    }
    std::int64_t left_of(const Step& s) const { return region_at(s.x + kLeftX[s.direction], s.y + kLeftY[s.direction]); }
    std::int64_t right_of(const Step& s) const { return region_at(s.x + kRightX[s.direction], s.y + kRightY[s.direction]); }

    // More than two borders come together here.
    bool is_meeting(int x, int y) const {
        int borders = 0;
        for (int d = 0; d < 4; ++d) borders += left_of({x, y, d}) != right_of({x, y, d}) ? 1 : 0;
        return borders > 2;
    }

    void add_ring(const Step& start) {
        const std::int64_t region = right_of(start);
        std::vector<Step> steps;
        Step at = start;
        do {
            seen_[key(at)] = true;
            steps.push_back(at);
            Step next{at.x + kX[at.direction], at.y + kY[at.direction], at.direction};
            // Regions do not join over corners.
            if (right_of(next) != region)
                next.direction = (next.direction + 1) & 3;
            else if (left_of(next) == region)
                next.direction = (next.direction + 3) & 3;
            at = next;
        } while (key(at) != key(start));

        auto first = std::find_if(steps.begin(), steps.end(), [this](const Step& s) { return is_meeting(s.x, s.y); });
        const bool closed = first == steps.end();
        // A ring that meets no third region begins where both sides begin it.
        if (closed)
            first = std::min_element(steps.begin(), steps.end(), [this](const Step& a, const Step& b) {
                return key({a.x, a.y, 0}) < key({b.x, b.y, 0});
            });
        std::rotate(steps.begin(), first, steps.end());

        BorderRing ring{static_cast<std::uint32_t>(region), {}};
        for (std::size_t begin = 0; begin < steps.size();) {
            std::size_t end = begin + 1;
            while (end < steps.size() && (closed || !is_meeting(steps[end].x, steps[end].y))) ++end;
            ring.parts.push_back(part(
                {steps.begin() + static_cast<std::ptrdiff_t>(begin), steps.begin() + static_cast<std::ptrdiff_t>(end)}, closed));
            begin = end;
        }
        found_.rings.push_back(std::move(ring));
    }

    BorderRing::Part part(const std::vector<Step>& steps, bool closed) {
        if (const auto known = border_from_.find(key(steps.back().back())); known != border_from_.end())
            return {known->second, true};
        const std::size_t index = found_.borders.size();
        border_from_.emplace(key(steps.front()), index);
        Border border{{}, closed, static_cast<std::uint32_t>(right_of(steps[0])), left_of(steps[0])};
        const bool frame = border.other < 0;
        const auto end = steps.back().back();
        // Along the picture's frame corners count, between regions the middles of the pixels' sides.
        if (!closed || frame) border.points.push_back({static_cast<double>(steps[0].x), static_cast<double>(steps[0].y)});
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const Step& s = steps[i];
            if (!frame)
                border.points.push_back({s.x + kX[s.direction] / 2.0, s.y + kY[s.direction] / 2.0});
            else if (i > 0 && s.direction != steps[i - 1].direction)
                border.points.push_back({static_cast<double>(s.x), static_cast<double>(s.y)});
        }
        if (!closed) border.points.push_back({static_cast<double>(end.x), static_cast<double>(end.y)});
        if (!frame) shape(border);
        found_.borders.push_back(std::move(border));
        return {index, false};
    }

    // The ends stay, where other borders end too.
    void shape(Border& border) const {
        const Point first = border.points.front(), last = border.points.back();
        std::vector<Point> points = smooth(border.points, border.closed);
        if (points.size() < (border.closed ? 3u : 2u)) return;
        if (!border.closed) {
            points.front() = first;
            points.back() = last;
        }
        std::vector<bool> keep(points.size(), false);
        keep.front() = keep.back() = true;
        if (border.closed) {
            // As two lines; a third point keeps it a ring.
            const std::size_t half = points.size() / 2;
            keep[half] = keep[half / 2] = true;
            keep_course(points, 0, half / 2, tolerance_, keep);
            keep_course(points, half / 2, half, tolerance_, keep);
            keep_course(points, half, points.size() - 1, tolerance_, keep);
        } else {
            keep_course(points, 0, points.size() - 1, tolerance_, keep);
        }
        border.points.clear();
        for (std::size_t i = 0; i < points.size(); ++i)
            if (keep[i]) border.points.push_back(points[i]);
    }

    const RegionMap& map_;
    double tolerance_;
    std::vector<bool> seen_;
    std::unordered_map<std::size_t, std::size_t> border_from_;  // by its first step
    RegionBorders found_;
};

}  // namespace

std::vector<Point> RegionBorders::points_of(const BorderRing& ring) const {
    std::vector<Point> points;
    for (const auto& [index, backwards] : ring.parts) {
        std::vector<Point> part = borders[index].points;
        if (backwards) std::reverse(part.begin(), part.end());
        if (!borders[index].closed) part.pop_back();  // the next one begins there
        points.insert(points.end(), part.begin(), part.end());
    }
    return points;
}

RegionBorders borders_of(const RegionMap& map, double tolerance) { return Tracer(map, tolerance).trace(); }

}  // namespace tactics
