// SPDX-License-Identifier: Apache-2.0
// The black share of a page.
#pragma once

#include <optional>
#include <string>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

/// Percent of the paper that lines, areas, braille and picture blacken together; overlaps count once. Exact along each of up to
/// 3000 lines across the page (0.1 mm apart on A4), which makes it right to about 0.1 %. On a page that is covered many times
/// over, the lines are farther apart; nothing for one that is too full even so.
std::optional<double> percent_black(const PageGeometry& geometry);

inline std::optional<double> only_swell(const Medium& medium, double limit) {
    return medium.swells == Swells::yes ? std::optional(limit) : std::nullopt;
}

/// One finding for the whole page.
Findings ink_beyond(const PageGeometry& geometry, double limit);

}  // namespace tactics
