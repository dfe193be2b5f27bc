// SPDX-License-Identifier: Apache-2.0
#include "cli/chart_files.h"

#include "cli/outputs.h"
#include "cli/request.h"
#include "filters/chart.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/job/page_files.h"
#include "tactics/layout/lay_out.h"
#include "tactics/transport/file.h"

namespace tactics {

namespace {

// What is wrong with an output, as the user wrote it.
Error with_own_name(const Error& error, std::string_view flag) {
    const std::string message = error.what();
    if (!message.starts_with("-o") || flag == "--output") return error;
    const auto colon = message.find(": ");
    return {error.fault(), std::string(flag) + message.substr(2, colon - 2), message.substr(colon + 2)};
}

}  // namespace

std::vector<ChartFile> plan_chart_files(const Given& given, std::string_view flag, const Disk& disk) {
    const std::string shown(flag == "--output" ? "-o" : flag);
    std::vector<ChartFile> charts;
    try {
        const Request request = plan_charts(plan_outputs({"-"}, given.all(flag), {}, disk), given);
        for (const Output& output : request.items.front().outputs) {
            if (!output.folder.empty())
                throw Error(Fault::usage, shown + " " + output.folder,
                            phrase("this is a folder; name a file, for example chart.pdf"));
            charts.push_back({output.format, output.path, sheet_for(request, *output.format, request.items.front()),
                              request.settings_of(*output.format), shown + " " + output.path});
        }
        const Sheet& sheet = charts.front().sheet;
        if (!sheet.braille_table.empty()) to_braille(sheet.title, sheet.braille_table);
    } catch (const Error& error) {
        throw with_own_name(error, flag);
    }
    return charts;
}

Page chart_page(const Plot& plot, const ChartFile& chart) {
    Sheet sheet = chart.sheet;
    if (sheet.title.empty()) {
        sheet.title = plot.title;
        sheet.title_origin = "its title";
    }
    try {
        sheet = sheet_of_chart(plot, sheet);
        return lay_out(draw_chart(plot, sheet), sheet);
    } catch (const Error& error) {
        throw Error(error.fault(), chart.place, error.what());
    }
}

void write_chart_files(const Plot& plot, const std::vector<ChartFile>& charts) { write_chart_pages({plot}, charts); }

void write_chart_pages(const std::vector<Plot>& plots, const std::vector<ChartFile>& charts) {
    std::vector<std::string> bytes;
    std::vector<NewFile> files;
    bytes.reserve(plots.size() * charts.size());
    for (const ChartFile& chart : charts) {
        std::vector<Page> pages;
        for (const Plot& plot : plots) pages.push_back(chart_page(plot, chart));
        const bool in_one = chart.format->encode_pages != nullptr;
        for (std::size_t i = 0; i < (in_one ? 1 : pages.size()); ++i) {
            bytes.push_back(in_one ? chart.format->encode_pages(pages, chart.settings)
                                   : chart.format->encode(pages[i], chart.settings));
            files.push_back({path_of_page({chart.format, chart.path, ""}, i + 1), bytes.back()});
        }
    }
    write_files(files);
}

std::vector<std::string> file_names(const ChartFile& chart, std::size_t pages, const Disk& disk) {
    const Output output{chart.format, chart.path, ""};
    if (chart.format->encode_pages != nullptr) return {chart.path};
    check_page_files(output, pages, {}, disk);
    std::vector<std::string> names;
    for (std::size_t page = 1; page <= pages; ++page) names.push_back(path_of_page(output, page));
    return names;
}

}  // namespace tactics
