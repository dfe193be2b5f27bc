// SPDX-License-Identifier: Apache-2.0
#include "studies/frontier.h"

#include <algorithm>

namespace tactics {

std::vector<std::string> recipes_alone(std::span<const Candidate> candidates) {
    std::vector<std::string> names;
    for (const Candidate& candidate : candidates) names.push_back(candidate.name);
    return names;
}

std::vector<std::string> recipes_and_person(std::span<const Candidate> candidates) {
    std::vector<std::string> names = recipes_alone(candidates);
    names.emplace_back("simplest person");
    return names;
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
        plot.marks[i].symbol = best[i] ? PlotSymbol::disc : PlotSymbol::ring;
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
        if (figures.scored > 0) plot.marks.push_back({recipe.recipe, figures.whole_ms, figures.best.f(), PlotSymbol::ring});
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

}  // namespace tactics
