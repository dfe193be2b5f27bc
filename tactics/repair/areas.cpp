// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "tactics/repair/means.h"
#include "tactics/rules/coverage.h"

namespace tactics {

namespace {

// A shape whose sides are shorter may not be recognised (APH guide): its outline would not be either.
constexpr double kRecognised = 12.7;  // mm

double extent_of(const Area& area) {
    std::vector<Point> points;
    for (const auto& ring : area.rings) points.insert(points.end(), ring.begin(), ring.end());
    return greatest_extent(points);
}

// To this much less than the limit, in percent of the paper; then it is measured again.
constexpr double kInkToSpare = 1;

double size_of(const Area& area) {  // square mm, holes taken off by the even-odd rule where they lie in their ring
    double most = 0, sum = 0;
    for (const auto& ring : area.rings) {
        double doubled = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            doubled += a.x * b.y - b.x * a.y;
        }
        most = std::max(most, std::abs(doubled) / 2);
        sum += std::abs(doubled) / 2;
    }
    return std::max(0.0, 2 * most - sum);
}

Point first_point(const Area& area) {
    for (const auto& ring : area.rings)
        if (!ring.empty()) return ring[0];
    return {};
}

// Its place is left empty, so that the others keep their numbers.
Mend to_outline(Drawing& drawing, std::size_t index) {
    Area area = std::move(drawing.areas[index]);
    drawing.areas[index].rings.clear();
    double length = 0;
    const Point at = first_point(area);
    for (auto& ring : area.rings) {
        length += length_of(Stroke{ring, true});
        if (ring.size() >= 3) drawing.strokes.push_back({std::move(ring), true, LineClass::normal, 0, area.role});
    }
    return {Mend::Kind::outlined, at, length};
}

void drop_empty(std::vector<Area>& areas) {
    std::erase_if(areas, [](const Area& area) { return area.rings.empty(); });
}

}  // namespace

Mends lighten(Drawing& drawing, const Medium& medium) {
    Mends changes;
    const auto limit = limit_of(*find_rule("ink-limit"), medium);
    if (!limit) return changes;
    std::vector<std::pair<double, std::size_t>> black;  // size and number, the largest last
    for (std::size_t i = 0; i < drawing.areas.size(); ++i)
        if (const Area& area = drawing.areas[i]; area.texture == 0 && !area.rings.empty() && !area.rings[0].empty())
            black.push_back({size_of(area), i});
    std::sort(black.begin(), black.end());
    while (!black.empty()) {
        const Page page = page_of(drawing, medium);
        const auto percent = percent_black(PageGeometry(page));
        if (!percent || *percent <= *limit) break;
        double spare = (*percent - *limit + kInkToSpare) / 100 * drawing.width * drawing.height;
        for (; spare > 0 && !black.empty(); black.pop_back()) {
            spare -= black.back().first;
            changes.push_back(to_outline(drawing, black.back().second));
        }
    }
    drop_empty(drawing.areas);
    return changes;
}

Mends outline_areas(Drawing& drawing, const Seen& seen) {
    Mends changes;
    if (drawing.areas.empty()) return changes;
    const PageGeometry& geometry = seen.geometry;
    const std::vector<std::size_t> worth = worth_of(geometry, drawing);
    std::set<std::size_t> too_close;  // areas
    for (const NearPair& pair : seen.near.pairs) {
        const std::uint32_t a = geometry.pieces[pair.one].chain, b = geometry.pieces[pair.other].chain;
        if (!geometry.chains[a].ring || !geometry.chains[b].ring) continue;
        too_close.insert(geometry.chains[worth[a] < worth[b] ? a : b].owner);
    }
    for (const std::size_t i : too_close) {
        Area& area = drawing.areas[i];
        if (extent_of(area) >= kRecognised) {
            changes.push_back(to_outline(drawing, i));
            continue;
        }
        double length = 0;
        for (const auto& ring : area.rings) length += length_of(Stroke{ring, true});
        changes.push_back({Mend::Kind::left_out, first_point(area), length});
        area.rings.clear();
    }
    drop_empty(drawing.areas);
    return changes;
}

}  // namespace tactics
