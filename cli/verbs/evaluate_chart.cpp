// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/evaluate_chart.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"

namespace tactics {

namespace {

// Of evaluate's options those that a page has in convert, too.
}  // namespace

std::vector<ChartFile> plan_charts(const Given& given, const Disk& disk) {
    if (!given.has("--chart")) {
        for (const std::string_view flag : {"--orientation", "--title", "--no-print-title", "--braille", "--dpi"})
            if (given.has(flag))
                throw Error(Fault::usage, flag, "no chart is drawn, so this would do nothing; add --chart FILE, or leave it out");
        return {};
    }
    std::vector<ChartFile> charts = plan_chart_files(given, "--chart", disk);
    for (const ChartFile& chart : charts)
        if (chart.path == "-") throw Error(Fault::usage, "--chart", "the results are written to standard output; name a file");
    return charts;
}

void check_charts(const std::vector<std::string>& names, const std::vector<ChartFile>& charts) {
    Plot plot{"Contours found, against time", {"ms for a picture", true}, {"F of contours", false}, {}, {}};
    for (const std::string& name : names) plot.marks.push_back({name, std::pow(10, plot.marks.size() % 3), 0.5, true});
    for (const ChartFile& chart : charts) chart_page(plot, chart);
}

std::vector<bool> on_frontier(const std::vector<PlotPoint>& points) {
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y > points[b].y;
    });
    std::vector<bool> best(points.size(), false);
    const PlotPoint* last = nullptr;  // the last that none beats
    for (const std::size_t i : order) {
        const bool same = last != nullptr && points[i].x == last->x && points[i].y == last->y;
        best[i] = same || last == nullptr || points[i].y > last->y;
        if (best[i]) last = &points[i];
    }
    return best;
}

void join_frontier(Plot& plot) {
    constexpr double kLeastTime = 0.001;  // ms: a logarithm needs one
    for (PlotMark& mark : plot.marks) mark.x = std::max(mark.x, kLeastTime);
    // Letters go from left to right as the marks do.
    std::stable_sort(plot.marks.begin(), plot.marks.end(), [](const PlotMark& a, const PlotMark& b) { return a.x < b.x; });
    std::vector<PlotPoint> points;
    for (const PlotMark& mark : plot.marks) points.push_back({mark.x, mark.y});
    const std::vector<bool> best = on_frontier(points);
    PlotCurve frontier;
    for (std::size_t i = 0; i < points.size(); ++i) {
        plot.marks[i].filled = best[i];
        if (best[i]) frontier.points.push_back(points[i]);
    }
    plot.curves.push_back(std::move(frontier));
}

void add_level(Plot& plot, const std::string& name, double y) {
    if (plot.marks.empty()) return;
    const auto [first, last] =
        std::minmax_element(plot.marks.begin(), plot.marks.end(), [](const PlotMark& a, const PlotMark& b) { return a.x < b.x; });
    constexpr double kBeyond = 1.25;  // so that one mark alone has a line, too
    plot.curves.push_back({name, {{first->x / kBeyond, y}, {last->x * kBeyond, y}}});
}

Plot frontier_plot(const Evaluation& evaluation) {
    Plot plot{"Contours found, against time", {"ms for a picture", true}, {"F of contours", false}, {}, {}};
    for (const RecipeResult& recipe : evaluation.recipes) {
        const Figures figures = figures_of(recipe);
        if (figures.scored > 0) plot.marks.push_back({recipe.recipe, figures.whole_ms, figures.best.f(), false});
    }
    join_frontier(plot);
    if (const Counts person = sum_of(evaluation.simplest); person.truth > 0) add_level(plot, "simplest person", person.f());
    return plot;
}

std::string with_word(const std::string& path, const std::string& word) {
    const auto dot = path.rfind('.');
    const bool ending = dot != std::string::npos && path.find('/', dot) == std::string::npos;
    return ending ? path.substr(0, dot) + "-" + word + path.substr(dot) : path + "-" + word;
}

void write_charts(const Plot& plot, const std::vector<ChartFile>& charts) {
    const bool empty = plot.marks.empty() && std::all_of(plot.curves.begin(), plot.curves.end(),
                                                         [](const PlotCurve& curve) { return curve.points.empty(); });
    if (empty) throw Error(Fault::failed, "--chart", "no recipe could be scored, so there is nothing to draw");
    write_chart_files(plot, charts);
}

}  // namespace tactics
