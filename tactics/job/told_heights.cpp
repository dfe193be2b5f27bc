// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/told_heights.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tactics/text/table.h"

namespace tactics {

namespace {

Phrase name_of(LineKind kind) {
    switch (kind) {
        case LineKind::values: return phrase("axes, ticks and lead lines");
        case LineKind::grid: return phrase("grid lines");
        case LineKind::pattern: return phrase("patterns");
        case LineKind::drawn: break;
    }
    return phrase("the drawing and braille");
}

}  // namespace

std::optional<KindHeights> chosen_heights(const Format& format, const Settings& settings, std::span<const Page> pages) {
    if (format.dots == nullptr || pages.empty()) return std::nullopt;
    const int most = format.dots(settings).levels - 1;
    const auto is_wished = [&](std::string_view name) { return !name.empty() && !settings.is_default(name); };
    if (most < 2 || std::any_of(std::begin(kKindSettings), std::end(kKindSettings), is_wished)) return std::nullopt;
    return kind_heights(format.encode_pages != nullptr ? pages : pages.first(1), most);
}

Phrase explained(const KindHeights& heights, const Format& format) {
    if (heights.used == 1)
        return phrase("{0} has {1} heights, and 1 is used: all lines are of one kind, of which more heights would tell nothing",
                      format.name, std::to_string(heights.most));
    std::vector<Phrase> kinds, losses;
    for (std::size_t kind = 0; kind < kLineKinds; ++kind)
        if (heights.there[kind])
            kinds.push_back(
                phrase("{0}: {1}", name_of(static_cast<LineKind>(kind)), percent(heights.share(static_cast<LineKind>(kind)))));
    for (std::size_t i = 0; i < heights.losses.size(); ++i)
        losses.push_back(phrase("{0}: {1}", std::to_string(i + 1), percent(heights.losses[i])));
    return phrase(
        "{0} has {1} heights, and {2} are used ({3}), which lose the least of the bits about what a line is for (losses by "
        "number of heights: {4})",
        format.name, std::to_string(heights.most), std::to_string(heights.used), row_of(kinds), row_of(losses));
}

}  // namespace tactics
