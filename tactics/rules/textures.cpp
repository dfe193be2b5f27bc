// SPDX-License-Identifier: Apache-2.0
// A finger remembers few textures.
#include <map>

#include "tactics/layout/texture.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_textures(const PageGeometry& geometry, double limit) {
    std::map<int, std::size_t> first;  // area of each
    const auto& areas = geometry.page.textured;
    for (std::size_t i = 0; i < areas.size(); ++i)
        if (!areas[i].rings.empty() && !areas[i].rings[0].empty()) first.emplace(areas[i].texture, i);
    const auto count = static_cast<double>(first.size());
    if (count <= limit) return {};
    const auto& last = *first.rbegin();
    return {{{count,
              areas[last.second].rings[0][0],
              {},
              phrase("{0} textures, one of them here: {1}", shown(count), name_of_texture(last.first))}}};
}

}  // namespace

extern const Rule textures_rule;
const Rule textures_rule{
    .name = "textures",
    .summary = "few textures on one page",
    .mend = "leave areas that need no name blank, or divide the drawing over several pages",
    .source =
        "BANA Guidelines 3.2.2, as quoted by the NBA and the Tactile Graphics wiki: at most 5 textures that differ "
        "clearly",
    .confidence = Confidence::good,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 5,
              .min = 1,
              .max = 100,
              .summary = "maximum number of textures on a page; blank and black do not count"},
    .check = check_textures,
};

}  // namespace tactics
