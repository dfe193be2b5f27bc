// SPDX-License-Identifier: Apache-2.0
// Charts as pages: the sheets on which plots are drawn, and the files to which they are written.
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

/// A chart file with its sheet.
struct ChartFile {
    const Format* format = nullptr;
    std::string path;
    Sheet sheet;  ///< without a title unless the user named one
    Settings settings;
    std::string place;  ///< where it was named, for messages: "--chart page.pdf"
};

/// The files named by `flag`, checked like the outputs of convert; `page_flags` are the options that the command shares with it.
/// Throws Error(usage).
std::vector<ChartFile> plan_chart_files(const Given& given, std::string_view flag, const Disk& disk);

/// Throws Error if there is no room on the paper.
Page chart_page(const Plot& plot, const ChartFile& chart);

/// Lays the plot out on each sheet. Throws Error if there is no room on the paper, or a file cannot be written.
void write_chart_files(const Plot& plot, const std::vector<ChartFile>& charts);

/// A page for each plot: in one file if the format holds several, else in files side by side ("way-2.svg"), as given by
/// file_names.
void write_chart_pages(const std::vector<Plot>& plots, const std::vector<ChartFile>& charts);
/// The files for that many pages of a chart. Throws Error(usage) for several pages to standard output in a format that holds one.
std::vector<std::string> file_names(const ChartFile& chart, std::size_t pages, const Disk& disk);

}  // namespace tactics
