// SPDX-License-Identifier: Apache-2.0
// The files of evaluate's charts, laid out as any page.
#pragma once

#include <string>
#include <vector>

#include "cli/chart_files.h"

namespace tactics {

/// Checked as the outputs of convert are. Throws Error(usage).
std::vector<ChartFile> plan_charts(const Given& given, const Disk& disk);

/// Checks before any work that the names of these things have room on each sheet. Throws Error(usage).
void check_charts(const std::vector<std::string>& names, const std::vector<ChartFile>& charts);

/// Lays the plot out on each sheet. Throws Error if it is empty, has no room on the paper, or a file cannot be written.
void write_charts(const Plot& plot, const std::vector<ChartFile>& charts);

}  // namespace tactics
