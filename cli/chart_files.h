// SPDX-License-Identifier: Apache-2.0
// Charts as pages: what plots are drawn on, and the files that they are written to.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "print/format.h"
#include "tactics/job/disk.h"
#include "tactics/layout/sheet.h"
#include "tactics/plot.h"

namespace tactics {

/// A file of a chart with the sheet that it is laid out on.
struct ChartFile {
    const Format* format = nullptr;
    std::string path;
    Sheet sheet;  ///< without a title unless the user named one
    Settings settings;
    std::string place;  ///< what a message about it points to: "--chart page.pdf"
};

/// The files that `flag` names, checked as the outputs of convert are; `page_flags` are those that the command has in common with
/// it. Throws Error(usage).
std::vector<ChartFile> plan_chart_files(const Given& given, std::string_view flag, const Disk& disk);

/// Throws Error: no room on the paper.
Page chart_page(const Plot& plot, const ChartFile& chart);

/// Lays the plot out on each sheet. Throws Error: no room on the paper, or a file that cannot be written.
void write_chart_files(const Plot& plot, const std::vector<ChartFile>& charts);

/// A page for each plot, in a format that holds several in one file, else in files beside each other ("way-2.svg"), which
/// file_names tells.
void write_chart_pages(const std::vector<Plot>& plots, const std::vector<ChartFile>& charts);
/// The files that so many pages of a chart go to. Throws Error(usage): several to standard output that holds one.
std::vector<std::string> file_names(const ChartFile& chart, std::size_t pages, const Disk& disk);

}  // namespace tactics
