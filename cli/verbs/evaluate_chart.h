// SPDX-License-Identifier: Apache-2.0
// Charts of what came out of an evaluation, laid out as any page.
#pragma once

#include <string>
#include <vector>

#include "cli/chart_files.h"
#include "tactics/measure/evaluation.h"

namespace tactics {

/// Checked as the outputs of convert are. Throws Error(usage).
std::vector<ChartFile> plan_charts(const Given& given, const Disk& disk);

/// That things of these names will have room on each sheet, before any work starts. Throws Error(usage).
void check_charts(const std::vector<std::string>& names, const std::vector<ChartFile>& charts);

/// Whether each point is one that no other beats: none is at most as far right and at least as high, and not the same.
std::vector<bool> on_frontier(const std::vector<PlotPoint>& points);

/// Sorts the marks by x, a time; fills those that none beats in both, and joins these with a curve.
void join_frontier(Plot& plot);

/// A level line through all marks: what people reach, who take no time that could be told.
void add_level(Plot& plot, const std::string& name, double y);

/// F against the time of a picture: a disc for each recipe that none beats in both, joined by a curve, rings for the others.
Plot frontier_plot(const Evaluation& evaluation);

/// Lays the plot out on each sheet. Throws Error: no room on the paper, or a file that cannot be written.
void write_charts(const Plot& plot, const std::vector<ChartFile>& charts);

/// "page.pdf" and "dpi" make "page-dpi.pdf".
std::string with_word(const std::string& path, const std::string& word);

}  // namespace tactics
