// SPDX-License-Identifier: Apache-2.0
// A texture keeps off the lines beside it, or neither is felt.
#include <algorithm>
#include <map>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

constexpr std::size_t kTextureClearanceMostPairs = 300'000'000;

Findings check_texture_clearance(const PageGeometry& geometry, double limit) {
    // For each line or edge, only the place nearest to a texture, because a pattern has thousands of marks.
    std::map<std::uint32_t, Nearest> worst;
    Findings findings;
    const auto is_mark = [&](std::size_t chain) { return geometry.role_of(geometry.chains[chain]) == Role::pattern; };
    const auto& strokes = geometry.page.strokes;
    if (std::none_of(strokes.begin(), strokes.end(), [](const PageStroke& s) { return s.role == Role::pattern; }))
        return findings;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < geometry.pieces.size(); ++i) boxes.push_back(geometry.box_of_piece(i, limit / 2));
    const Grid grid(std::move(boxes), geometry.page.width, geometry.page.height);
    findings.complete = grid.pairs(kTextureClearanceMostPairs, [&](std::size_t i, std::size_t j) {
        std::uint32_t mark = geometry.pieces[i].chain, other = geometry.pieces[j].chain;
        if (is_mark(mark) == is_mark(other)) return true;
        if (!is_mark(mark)) std::swap(mark, other);
        Nearest near = nearest(geometry.pieces[i].line, geometry.pieces[j].line);
        near.distance = std::max(0.0, near.distance - geometry.chains[mark].half_width - geometry.chains[other].half_width);
        if (near.distance >= limit - kRounding) return true;
        const auto known = worst.find(other);
        if (known == worst.end())
            worst.emplace(other, near);
        else if (near.distance < known->second.distance)
            known->second = near;
        return worst.size() <= kMostPlaces;
    });
    for (const auto& [chain, near] : worst) {
        const bool area = geometry.chains[chain].ring;
        findings.places.push_back({near.distance, near.one, near.other,
                                   near.distance > 0 ? (area ? phrase("a texture {0} mm from an area", shown(near.distance))
                                                             : phrase("a texture {0} mm from a line", shown(near.distance)))
                                   : area            ? phrase("a texture that touches an area")
                                                     : phrase("a texture that touches a line")});
    }
    return findings;
}

}  // namespace

extern const Rule texture_clearance_rule;
const Rule texture_clearance_rule{
    .name = "texture-clearance",
    .summary = "a clear gap between a texture and any line or black area",
    .mend = "cut the pattern back there",
    .source =
        "L. Hasty, Designing Tactile Graphics: 1/8 in is the absolute minimum between any two elements. The marks of a texture "
        "are one element, the line round it is another; the distance between marks is not measured. For thermoform this project "
        "asks for more",
    .confidence = Confidence::good,
    .hard = true,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 3.2,
              .min = 0.1,
              .max = 50,
              .unit = "mm",
              .summary = "minimum distance from edge to edge"},
    .limit_for = [](const Medium& medium) { return std::optional(medium.gap); },
    .check = check_texture_clearance,
};

}  // namespace tactics
