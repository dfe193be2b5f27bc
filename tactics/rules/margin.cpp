// SPDX-License-Identifier: Apache-2.0
// Things in the margin are not printed, not heated, or under the hand that holds the page.
#include <algorithm>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_margin(const PageGeometry& geometry, double limit) {
    Findings findings;
    const Rect& live = geometry.page.live;
    const double right = live.left + live.width, bottom = live.top + live.height;
    const auto off = [&](Point p) { return std::max({0.0, live.left - p.x, p.x - right, live.top - p.y, p.y - bottom}); };
    const auto look = [&](const auto& points, const Phrase& what) {
        Point worst;
        double most = 0;
        for (const Point& p : points)
            if (off(p) > most) {
                most = off(p);
                worst = p;
            }
        if (most > limit + kRounding)
            findings.places.push_back({most, worst, {}, phrase("{0} {1} mm into the margin", what, shown(most))});
    };
    for (const PageStroke& stroke : geometry.page.strokes) look(stroke.points, phrase("a line"));
    for (const Area& area : geometry.page.areas)
        for (const auto& ring : area.rings) look(ring, phrase("an area"));
    for (const Box& box : geometry.braille)
        look(std::vector<Point>{{box.left, box.top}, {box.right, box.bottom}}, phrase("braille"));
    if (const auto& picture = geometry.page.picture) {
        const Rect& p = picture->place;
        look(std::vector<Point>{{p.left, p.top}, {p.left + p.width, p.top + p.height}}, phrase("a picture"));
    }
    return findings;
}

}  // namespace

extern const Rule margin_rule;
const Rule margin_rule{
    .name = "margin",
    .summary = "everything within the page's margins",
    .mend = "move or scale it, or set another margin",
    .source = "this project's margins (tactics help swell). Lines are measured by their middles; print letters are not measured",
    .confidence = Confidence::uncertain,
    .hard = true,
    .limit = {.name = "most",
              .type = Option::Type::length,
              .fallback = 0,
              .min = 0,
              .max = 50,
              .unit = "mm",
              .summary = "maximum distance by which anything may reach into the margin"},
    .check = check_margin,
};

}  // namespace tactics
