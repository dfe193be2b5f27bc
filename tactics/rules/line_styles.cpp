// SPDX-License-Identifier: Apache-2.0
// A finger remembers few kinds of lines.
#include <cmath>
#include <map>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

// Widths nearer than this are meant to be one: what becomes of a width on its way through other units.
constexpr double kSame = 0.05;

struct Style {
    double width = 0;
    bool dashed = false;
    bool operator<(const Style& other) const { return width != other.width ? width < other.width : dashed < other.dashed; }
};

Findings check_line_styles(const PageGeometry& geometry, double limit) {
    struct Kind {
        std::size_t first, lines;
    };
    std::map<Style, Kind> kinds;
    for (std::size_t c = 0; c < geometry.chains.size(); ++c) {
        const Chain& chain = geometry.chains[c];
        if (chain.ring || geometry.role_of(chain) == Role::pattern) continue;
        const double width = std::round(chain.half_width * 2 / kSame) * kSame;
        const Role role = geometry.role_of(chain);
        ++kinds.emplace(Style{width, role == Role::dash || role == Role::dots}, Kind{c, 0}).first->second.lines;
    }
    const auto count = static_cast<double>(kinds.size());
    if (count <= limit) return {};
    auto rarest = kinds.begin();
    std::vector<Phrase> styles;
    std::size_t told = 0;
    for (auto kind = kinds.begin(); kind != kinds.end(); ++kind) {
        if (kind->second.lines < rarest->second.lines) rarest = kind;
        if (told++ < 8)
            styles.push_back(kind->first.dashed ? phrase("{0} mm dashed", shown(kind->first.width))
                                                : phrase("{0} mm", shown(kind->first.width)));
    }
    return {{{count,
              geometry.point_at({rarest->second.first, 0}),
              {},
              told > 8 ? phrase("lines of {0} styles ({1} ...), the rarest here", shown(count), row_of(styles))
                       : phrase("lines of {0} styles ({1}), the rarest here", shown(count), row_of(styles))}}};
}

}  // namespace

extern const Rule line_styles_rule;
const Rule line_styles_rule{
    .name = "line-styles",
    .summary = "few line styles on one page: widths, solid or dashed",
    .mend = "use fewer, or explain them in a key",
    .source = "Tactile Graphics wiki, Design Considerations: at most 5 line styles, else a key",
    .confidence = Confidence::medium,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 5,
              .min = 1,
              .max = 100,
              .summary = "maximum number of line styles on a page"},
    .check = check_line_styles,
};

}  // namespace tactics
