// A finger remembers few kinds of lines.
#include <cmath>
#include <map>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

// Widths nearer than this are meant to be one: what becomes of a width on its way through other units.
constexpr double kSame = 0.05;

Findings check(const PageGeometry& geometry, double limit) {
    struct Kind {
        std::size_t first, lines;
    };
    std::map<double, Kind> kinds;
    for (std::size_t c = 0; c < geometry.chains.size(); ++c) {
        if (geometry.chains[c].ring || geometry.chains[c].pattern) continue;
        const double width = std::round(geometry.chains[c].half_width * 2 / kSame) * kSame;
        ++kinds.emplace(width, Kind{c, 0}).first->second.lines;
    }
    const auto count = static_cast<double>(kinds.size());
    if (count <= limit) return {};
    auto rarest = kinds.begin();
    std::string widths;
    std::size_t told = 0;
    for (auto kind = kinds.begin(); kind != kinds.end(); ++kind) {
        if (kind->second.lines < rarest->second.lines) rarest = kind;
        if (told++ < 8) widths += (widths.empty() ? "" : ", ") + shown(kind->first);
    }
    return {{{count,
              geometry.point_at({rarest->second.first, 0}),
              {},
              "lines of " + shown(count) + " widths (" + widths + (told > 8 ? " ..." : "") + " mm), the rarest here"}}};
}

}  // namespace

extern const Rule line_widths_rule;
const Rule line_widths_rule{
    .name = "line-widths",
    .summary = "few widths of lines on one page",
    .mend = "use fewer, or explain them in a key",
    .source =
        "Tactile Graphics wiki, Design Considerations: at most 5 line styles, else a key. Of styles only widths are looked at",
    .confidence = Confidence::medium,
    .hard = false,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 5,
              .min = 1,
              .max = 100,
              .unit = "",
              .summary = "most widths of lines on a page",
              .choices = ""},
    .limit_for = nullptr,
    .check = check,
};

}  // namespace tactics
