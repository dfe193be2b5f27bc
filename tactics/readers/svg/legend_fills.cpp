// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/legend_fills.h"

#include <algorithm>
#include <cmath>

#include "tactics/geometry/course.h"
#include "tactics/layout/texture.h"
#include "tactics/readers/svg/chart_bars.h"
#include "tactics/readers/svg/chart_parts.h"

namespace tactics {

namespace {

constexpr double kRoomOfTexture = 8;  // mm of a figure that is 200 mm wide: a texture, and the gap to its outline
constexpr double kOnEachOther = 0.6;  // mm: neighbours have a border in common, and their lines have a width
constexpr std::size_t kMostCorners = 40'000;

struct Surface {
    std::size_t kind = 0;  // of the samples
    Rect box;
    std::vector<std::vector<Point>> rings;
};

bool is_within(const Surface& surface, Point p) {
    bool inside = false;
    double away = 1e9;
    for (const auto& ring : surface.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if (ray_meets(p, a, b)) inside = !inside;
            away = std::min(away, distance_to_segment(p, a, b));
        }
    return inside && away > kOnEachOther;
}

bool holds_some_of(const Surface& surface, const Surface& other) {
    for (const auto& ring : other.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if (is_within(surface, a) || is_within(surface, {(a.x + b.x) / 2, (a.y + b.y) / 2})) return true;
        }
    return false;
}

bool lie_on_each_other(const Surface& a, const Surface& b) {
    const double across = std::min(a.box.left + a.box.width, b.box.left + b.box.width) - std::max(a.box.left, b.box.left),
                 down = std::min(a.box.top + a.box.height, b.box.top + b.box.height) - std::max(a.box.top, b.box.top);
    return across > kOnEachOther && down > kOnEachOther && (holds_some_of(a, b) || holds_some_of(b, a));
}

// The darkest gets the texture with the most black; each other the one that feels least like those before.
std::vector<int> unlike_textures(std::size_t count) {
    std::vector<int> chosen;
    const auto apart = [&](int texture) {
        double least = 1e9;
        for (const int other : chosen) least = std::min(least, difference(texture, other));
        return chosen.empty() ? share_black(texture) : least;
    };
    while (chosen.size() < count) {
        int best = 0;
        for (int texture = 1; texture <= static_cast<int>(textures().size()); ++texture)
            if (std::find(chosen.begin(), chosen.end(), texture) == chosen.end() && (best == 0 || apart(texture) > apart(best)))
                best = texture;
        chosen.push_back(best);
    }
    std::sort(chosen.begin(), chosen.end(), [](int a, int b) { return share_black(a) > share_black(b); });
    return chosen;
}

// Its larger surfaces are filled on the page; what is small is, whatever its colour.
bool is_black(const FoundPage& figure, double fill) {
    return std::any_of(figure.looks.begin(), figure.looks.end(), [&](const FoundLook& look) {
        const Rect box = box_of(figure, look);
        return look.fill == fill && look.areas_end > look.area && std::min(box.width, box.height) >= kRoomOfTexture;
    });
}

std::vector<Surface> surfaces_like(const FoundPage& figure, const std::vector<std::size_t>& samples) {
    std::vector<Surface> surfaces;
    std::size_t corners = 0;
    for (std::size_t i = 0; i < figure.looks.size() && corners <= kMostCorners; ++i) {
        const FoundLook& look = figure.looks[i];
        const auto kind = std::find_if(samples.begin(), samples.end(),
                                       [&](std::size_t sample) { return figure.looks[sample].fill == look.fill; });
        if (kind == samples.end() || std::find(samples.begin(), samples.end(), i) != samples.end()) continue;
        Surface surface{static_cast<std::size_t>(kind - samples.begin()), box_of(figure, look), {}};
        for (std::size_t s = look.stroke; s < look.strokes_end; ++s)
            if (const PageStroke& stroke = figure.page.strokes[s]; stroke.closed && stroke.points.size() > 2)
                surface.rings.push_back(stroke.points);
        if (surface.rings.empty() || (figure.bars && outlines_bar(*figure.bars, surface.rings[0]))) continue;
        for (const auto& ring : surface.rings) corners += ring.size();
        surfaces.push_back(std::move(surface));
    }
    return corners <= kMostCorners ? surfaces : std::vector<Surface>{};
}

}  // namespace

void fill_as_legend(FoundPage& figure, std::vector<std::size_t> samples) {
    std::erase_if(samples, [&](std::size_t i) { return figure.looks[i].fill < 0; });
    if (samples.size() < 2) return;
    std::erase_if(samples, [&](std::size_t i) { return is_black(figure, figure.looks[i].fill); });
    if (samples.empty() || samples.size() > textures().size()) return;
    std::sort(samples.begin(), samples.end(),
              [&](std::size_t a, std::size_t b) { return figure.looks[a].fill < figure.looks[b].fill; });
    std::vector<Surface> surfaces = surfaces_like(figure, samples);
    for (std::size_t kind = 0; kind < samples.size(); ++kind)
        if (std::none_of(surfaces.begin(), surfaces.end(), [&](const Surface& one) {
                return one.kind == kind && std::min(one.box.width, one.box.height) >= kRoomOfTexture;
            }))
            return;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (surfaces[i].kind != surfaces[j].kind && lie_on_each_other(surfaces[i], surfaces[j])) return;
    const std::vector<int> chosen = unlike_textures(samples.size());
    for (Surface& surface : surfaces)
        if (std::min(surface.box.width, surface.box.height) >= kRoomOfTexture)
            figure.page.textured.push_back({std::move(surface.rings), Role::line, chosen[surface.kind]});
}

}  // namespace tactics
