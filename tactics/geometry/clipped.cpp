// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/clipped.h"

#include <algorithm>

namespace tactics {

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
            if (step == 0)
                within = within && room >= 0;
            else if (step < 0)
                from = std::max(from, room / step);
            else
                to = std::min(to, room / step);
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
