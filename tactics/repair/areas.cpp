#include <algorithm>
#include <limits>
#include <set>

#include "tactics/repair/means.h"

namespace tactics {

namespace {

// A shape whose sides are shorter may not be recognised (APH guide): its outline would not be either.
constexpr double kRecognised = 12.7;  // mm

double extent_of(const Area& area) {
    std::vector<Point> points;
    for (const auto& ring : area.rings) points.insert(points.end(), ring.begin(), ring.end());
    return greatest_extent(points);
}

}  // namespace

Mends outline_areas(Drawing& drawing, const Medium& medium) {
    Mends changes;
    if (drawing.areas.empty()) return changes;
    const Page page = page_of(drawing, medium);
    const PageGeometry geometry(page);
    const std::vector<std::size_t> worth = worth_of(geometry, drawing);
    std::set<std::size_t> too_close;  // areas
    for (const NearPair& pair : near_pairs(geometry, medium).pairs) {
        const std::uint32_t a = geometry.pieces[pair.one].chain, b = geometry.pieces[pair.other].chain;
        if (!geometry.chains[a].ring || !geometry.chains[b].ring) continue;
        too_close.insert(geometry.chains[worth[a] < worth[b] ? a : b].owner);
    }
    std::vector<Area> kept;
    for (std::size_t i = 0; i < drawing.areas.size(); ++i) {
        Area& area = drawing.areas[i];
        if (!too_close.contains(i)) {
            kept.push_back(std::move(area));
            continue;
        }
        const bool small = extent_of(area) < kRecognised;
        double length = 0;
        for (auto& ring : area.rings) {
            length += length_of(Stroke{ring, true});
            if (!small && ring.size() >= 3) drawing.strokes.push_back({ring, true});
        }
        changes.push_back({small ? Mend::Kind::left_out : Mend::Kind::outlined, area.rings.at(0).at(0), length});
    }
    drawing.areas = std::move(kept);
    return changes;
}

}  // namespace tactics
