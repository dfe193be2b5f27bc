// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/evaluate_chart.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"

namespace tactics {

std::vector<ChartFile> plan_charts(const Given& given, const Disk& disk) {
    if (!given.has("--chart")) {
        for (const std::string_view flag : {"--orientation", "--title", "--no-print-title", "--braille", "--dpi"})
            if (given.has(flag))
                throw Error(Fault::usage, flag,
                            phrase("no chart is drawn, so this would do nothing; add --chart FILE, or leave it out"));
        return {};
    }
    std::vector<ChartFile> charts = plan_chart_files(given, "--chart", disk);
    for (const ChartFile& chart : charts)
        if (chart.path == "-")
            throw Error(Fault::usage, "--chart", phrase("the results are written to standard output; name a file"));
    return charts;
}

void check_charts(const std::vector<std::string>& names, const std::vector<ChartFile>& charts) {
    Plot plot{"Contours found, against time", {"ms for a picture", true}, {"F of contours", false}, {}, {}};
    for (const std::string& name : names) plot.marks.push_back({name, std::pow(10, plot.marks.size() % 3), 0.5});
    for (const ChartFile& chart : charts) chart_page(plot, chart);
}

void write_charts(const Plot& plot, const std::vector<ChartFile>& charts) {
    const bool empty = plot.marks.empty() && std::all_of(plot.curves.begin(), plot.curves.end(),
                                                         [](const PlotCurve& curve) { return curve.points.empty(); });
    if (empty) throw Error(Fault::failed, "--chart", phrase("no recipe could be scored, so there is nothing to draw"));
    write_chart_files(plot, charts);
}

}  // namespace tactics
