#include "tactics/pages/clip.h"

#include <algorithm>

namespace tactics {

void Extent::add(Point p) {
    const double right = points == 0 ? p.x : std::max(box.left + box.width, p.x), bottom = points == 0 ? p.y : std::max(box.top + box.height, p.y);
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
    const double left = std::max(rect.left, std::min(corner.x, opposite.x)), top = std::max(rect.top, std::min(corner.y, opposite.y));
    const double right = std::min(rect.left + rect.width, std::max(corner.x, opposite.x));
    const double bottom = std::min(rect.top + rect.height, std::max(corner.y, opposite.y));
    return {left, top, std::max(0.0, right - left), std::max(0.0, bottom - top)};
}

bool lies_in(const std::vector<Point>& points, const Rect& rect) {
    return std::all_of(points.begin(), points.end(), [&](Point p) {
        return p.x >= rect.left && p.x <= rect.left + rect.width && p.y >= rect.top && p.y <= rect.top + rect.height;
    });
}

std::vector<std::vector<Point>> clipped(const std::vector<Point>& points, bool closed, const Rect& rect) {
    std::vector<std::vector<Point>> parts;
    bool open = false;  // the last part goes on
    const std::size_t sides = points.empty() ? 0 : points.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < sides; ++i) {
        const Point a = points[i], b = points[(i + 1) % points.size()], way{b.x - a.x, b.y - a.y};
        // Y.-D. Liang and B. Barsky, 1984: from where to where along the side it is within each border.
        double from = 0, to = 1;
        bool within = true;
        const auto border = [&](double step, double room) {
            if (step == 0) within = within && room >= 0;
            else if (step < 0) from = std::max(from, room / step);
            else to = std::min(to, room / step);
        };
        border(-way.x, a.x - rect.left);
        border(way.x, rect.left + rect.width - a.x);
        border(-way.y, a.y - rect.top);
        border(way.y, rect.top + rect.height - a.y);
        if (!within || from > to) {
            open = false;
            continue;
        }
        if (!open || from > 0) parts.push_back({{a.x + from * way.x, a.y + from * way.y}});
        parts.back().push_back({a.x + to * way.x, a.y + to * way.y});
        open = to >= 1;
    }
    return parts;
}

}  // namespace tactics
