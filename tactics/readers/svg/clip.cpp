// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactics {

void Extent::add(Point p) {
    const double right = points == 0 ? p.x : std::max(box.left + box.width, p.x),
                 bottom = points == 0 ? p.y : std::max(box.top + box.height, p.y);
    box.left = points == 0 ? p.x : std::min(box.left, p.x);
    box.top = points == 0 ? p.y : std::min(box.top, p.y);
    box.width = right - box.left;
    box.height = bottom - box.top;
    ++points;
}

void add_all(Extent& extent, const std::vector<Subpath>& subpaths) {
    for (const Subpath& subpath : subpaths)
        for (const Point& p : subpath.points) extent.add(p);
}

Rect common_of(const Rect& rect, Point corner, Point opposite) {
    const double left = std::max(rect.left, std::min(corner.x, opposite.x)),
                 top = std::max(rect.top, std::min(corner.y, opposite.y));
    const double right = std::min(rect.left + rect.width, std::max(corner.x, opposite.x));
    const double bottom = std::min(rect.top + rect.height, std::max(corner.y, opposite.y));
    return {left, top, std::max(0.0, right - left), std::max(0.0, bottom - top)};
}

// What lies on the border does, whatever the last digits say: else it would depend on the size of the file's units.
bool lies_in(const std::vector<Point>& points, const Rect& rect) {
    constexpr double kRounded = 1e-6;  // mm
    const Rect wider{rect.left - kRounded, rect.top - kRounded, rect.width + 2 * kRounded, rect.height + 2 * kRounded};
    return std::all_of(points.begin(), points.end(), [&](Point p) { return wider.holds(p); });
}

bool is_within(const Subpath& subpath, double farthest) {
    return std::all_of(subpath.points.begin(), subpath.points.end(),
                       [&](Point p) { return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest; });
}

void add_clipped(Page& page, PageStroke stroke, const std::optional<Rect>& clip) {
    if (!clip || lies_in(stroke.points, *clip)) {
        page.strokes.push_back(std::move(stroke));
        return;
    }
    for (auto& part : clipped(stroke.points, stroke.closed, *clip))
        page.strokes.push_back({std::move(part), false, stroke.width, stroke.role, stroke.inner, stroke.heavy});
}

}  // namespace tactics
