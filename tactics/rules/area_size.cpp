// SPDX-License-Identifier: Apache-2.0
// A black area must be large enough to be felt as an area.
#include <algorithm>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_area_size(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const auto& figure : geometry.figures) {
        const auto ring = std::find_if(figure.begin(), figure.end(), [&](std::uint32_t c) {
            return geometry.chains[c].ring && geometry.role_of(geometry.chains[c]) == Role::line &&
                   !geometry.is_hole(geometry.chains[c]);
        });
        const bool part = std::any_of(figure.begin(), figure.end(), [&](std::uint32_t c) { return !geometry.chains[c].closed; });
        if (ring == figure.end() || part) continue;  // an arrow's head is a part of its line
        const double extent = geometry.extent_of(figure, limit);
        if (extent < limit - kRounding)
            findings.places.push_back(
                {extent, geometry.point_at({*ring, 0}), {}, phrase("a black area {0} mm across", shown(extent))});
    }
    return findings;
}

}  // namespace

extern const Rule area_size_rule;
const Rule area_size_rule{
    .name = "area-size",
    .summary = "black areas large enough to be felt as areas",
    .mend = "draw it larger, draw its outline or leave it out",
    .source =
        "L. Hasty, Designing Tactile Graphics: a separate texture must be at least 1/4 in to be felt as such. Measured along "
        "its longest extent",
    .confidence = Confidence::good,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 6.4,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum size of an area, measured along its longest extent"},
    .check = check_area_size,
};

}  // namespace tactics
