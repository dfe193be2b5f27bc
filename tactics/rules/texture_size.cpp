// SPDX-License-Identifier: Apache-2.0
// There must be enough of a texture for a finger to know it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/geometry/course.h"
#include "tactics/layout/texture.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

// Limit of sides examined to find the area of each mark.
constexpr std::size_t kMostSides = 500'000'000;

struct Component {
    const Area* area = nullptr;
    Box box = kNothing;
    std::vector<Point> marks = {};  // ends of their middle lines
    double width = 0;
};

bool holds(const Area& area, Point p, std::size_t& budget) {
    bool inside = false;
    for (const auto& ring : area.rings) {
        budget -= std::min(budget, ring.size());
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
            if (ray_meets(p, a, b)) inside = !inside;
        }
    }
    return inside;
}

// The narrowest of 180 directions, at most 0.02 % too wide for what is no more than a hundred times as long as wide.
double narrowest(const std::vector<Point>& points) {
    double least = 1e300;
    for (int degree = 0; degree < 180; ++degree) {
        const double x = std::cos(degree * std::numbers::pi / 180), y = std::sin(degree * std::numbers::pi / 180);
        double low = 1e300, high = -1e300;
        for (const Point& p : points) {
            low = std::min(low, p.x * x + p.y * y);
            high = std::max(high, p.x * x + p.y * y);
        }
        least = std::min(least, high - low);
    }
    return least;
}

Findings check_texture_size(const PageGeometry& geometry, double limit) {
    std::vector<Component> components;
    for (const Area& area : geometry.page.textured) {
        Component component{.area = &area};
        for (const auto& ring : area.rings)
            for (const Point& p : ring) component.box.take(p);
        if (component.box.left <= component.box.right) components.push_back(std::move(component));
    }
    Findings findings;
    std::size_t budget = kMostSides;
    for (const PageStroke& stroke : geometry.page.strokes) {
        if (stroke.role != Role::pattern || stroke.points.empty()) continue;
        const Point p = stroke.points[0];
        for (Component& c : components) {
            if (!c.box.holds(p) || !holds(*c.area, p, budget)) continue;
            c.marks.insert(c.marks.end(), stroke.points.begin(), stroke.points.end());
            c.width = std::max(c.width, stroke.width);
            break;
        }
        if (budget == 0) return {{}, false};
    }
    for (const Component& c : components) {
        const double across = c.marks.empty() ? 0 : narrowest(c.marks) + c.width;
        if (across >= limit - kRounding) continue;
        const Phrase name = name_of_texture(c.area->texture);
        findings.places.push_back({across,
                                   c.marks.empty() ? c.area->rings[0][0] : c.marks[0],
                                   {},
                                   c.marks.empty() ? phrase("an area without room for its texture, {0}", name)
                                                   : phrase("{0} only {1} mm wide", name, shown(across))});
    }
    return findings;
}

}  // namespace

extern const Rule texture_size_rule;
const Rule texture_size_rule{
    .name = "texture-size",
    .summary = "textured areas large enough for the texture to be recognised",
    .mend = "draw the area larger, or leave it blank",
    .source =
        "L. Hasty, Designing Tactile Graphics: a component is felt as a separate texture from 1/4 in on. Measured across the "
        "drawn part of the pattern, where it is narrowest",
    .confidence = Confidence::good,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = kLeastTexture,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum width of the drawn part of a texture"},
    .check = check_texture_size,
};

}  // namespace tactics
