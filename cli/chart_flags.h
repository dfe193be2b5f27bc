// SPDX-License-Identifier: Apache-2.0
// Options for drawing plots.
#pragma once

#include "cli/command.h"
#include "filters/chart.h"

namespace tactics {

inline constexpr Flag kChartGridFlag{
    "--grid", "", "", "grid lines at the ticks, weaker than the axes, broken round data and words", false, ""};
inline constexpr Flag kChartViewFlag{"--view",
                                     "",
                                     "contours|sections|heights",
                                     "how a surface is shown: as lines of equal height with their values, as curves of its "
                                     "height along lines across it, or, in height formats, as itself; default: contours",
                                     false,
                                     "contours sections heights"};
inline constexpr Flag kChartLevelsFlag{"--levels",
                                       "",
                                       "NUMBER|auto",
                                       "maximum number of contours, 3 to 20, at round heights; auto: as many as a finger can "
                                       "tell apart, 3 to 8",
                                       false,
                                       "auto"};
inline constexpr Flag kChartSectionFlag{
    "--section", "", "y=2,5,8|x=...", "where the sections are, at most five; default: up to five round values of y", false, ""};

/// --levels; 0: as many as a finger can tell apart. Throws Error(usage).
int levels_value(const Given& given);
/// --section. Throws Error(usage).
SectionWish section_value(const Given& given);

/// Throws Error(usage).
ChartWish chart_wish(const Given& given);

}  // namespace tactics
