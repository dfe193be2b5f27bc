// SPDX-License-Identifier: Apache-2.0
// Flags about how a plot is drawn.
#pragma once

#include "cli/command.h"
#include "filters/chart.h"

namespace tactics {

inline constexpr Flag kChartGridFlag{
    "--grid", "", "", "grid lines at the ticks, weaker than the axes, broken round data and words", false, ""};
inline constexpr Flag kChartViewFlag{"--view",
                                     "",
                                     "contours|sections|heights",
                                     "how a surface is shown: lines of equal height with their values, curves of its height "
                                     "along lines across it, or, in formats of "
                                     "heights, itself; contours if nothing is said",
                                     false,
                                     "contours sections heights"};
inline constexpr Flag kChartLevelsFlag{
    "--levels", "",    "NUMBER|auto", "contours at most, 3 to 20, at round heights; auto: as many as a finger tells, 3 to 8",
    false,      "auto"};
inline constexpr Flag kChartSectionFlag{
    "--section", "", "y=2,5,8|x=...", "where sections are, at most five; up to five round values of y if nothing is said",
    false,       ""};

/// --levels; 0: as many as a finger tells. Throws Error(usage).
int levels_value(const Given& given);
/// --section. Throws Error(usage).
SectionWish section_value(const Given& given);

/// Throws Error(usage).
ChartWish chart_wish(const Given& given);

}  // namespace tactics
