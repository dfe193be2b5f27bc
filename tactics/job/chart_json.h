// SPDX-License-Identifier: Apache-2.0
// A chart as JSON: how values were drawn, and where they are on the page.
#pragma once

#include <string>

#include "filters/chart.h"
#include "tactics/layout/sheet.h"

namespace tactics {

inline constexpr std::size_t kMostToldValues = 1'000'000;

/// One object, one line: "title"; "x" and "y", each an axis with its name and, if it has values, "low" and "high" with their
/// places on the page in mm from the left or the top, "from" and "to"; then "bars", "curves", "marks" and "surfaces" with all
/// values as the table has them, null where unknown. Throws Error(usage) if there are more than kMostToldValues.
std::string chart_json(const Plot& plot, const ChartTold& told, const Sheet& sheet);

}  // namespace tactics
