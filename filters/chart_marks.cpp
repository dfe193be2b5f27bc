// SPDX-License-Identifier: Apache-2.0
#include "filters/chart_marks.h"

#include <algorithm>
#include <set>
#include <utility>

#include "filters/plot_symbols.h"
#include "tactics/geometry/places.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::size_t index_of(PlotSymbol symbol) { return static_cast<std::size_t>(symbol); }

}  // namespace

MarkGroups groups_of(const std::vector<PlotMark>& marks) {
    std::array<std::size_t, kSymbols> all{}, named{};
    for (const PlotMark& mark : marks) {
        ++all[index_of(mark.symbol)];
        named[index_of(mark.symbol)] += mark.name.empty() ? 0 : 1;
    }
    MarkGroups groups;
    bool any = false;
    for (std::size_t i = 0; i < all.size(); ++i) any = any || (named[i] == 1 && all[i] > 1);
    for (std::size_t i = 0; i < all.size(); ++i) groups.is_group[i] = any && named[i] == 1;
    return groups;
}

bool flatten_marks(Plot& plot, std::string_view language) {
    if (!plot.spatial || plot.marks.empty()) return false;
    const MarkGroups groups = groups_of(plot.marks);
    std::set<PlotSymbol> kinds;
    AxisExtent heights;
    for (PlotMark& mark : plot.marks) {
        heights.take(mark.z);
        kinds.insert(mark.symbol);
        if (!mark.name.empty() && !groups.has(mark.symbol)) mark.name += ", " + told_value(plot.z, mark.z);
    }
    const auto silent = [&](const PlotMark& mark) { return mark.name.empty() || groups.has(mark.symbol); };
    if (std::none_of(plot.marks.begin(), plot.marks.end(), silent)) return false;
    if (kinds.size() > 1 || !(heights.low < heights.high)) return kinds.size() > 1;
    // The higher, the more of it is felt.
    constexpr std::array kByHeight{PlotSymbol::ring, PlotSymbol::cross, PlotSymbol::triangle};
    std::array<bool, kByHeight.size()> told{};
    std::array<AxisExtent, kByHeight.size()> thirds;
    const auto third = [&](const PlotMark& mark) {
        const double share = (mark.z - heights.low) / (heights.high - heights.low);
        return std::min(static_cast<std::size_t>(3 * share), kByHeight.size() - 1);
    };
    for (const PlotMark& mark : plot.marks) thirds[third(mark)].take(mark.z);
    for (PlotMark& mark : plot.marks) {
        if (!silent(mark)) continue;
        const std::size_t i = third(mark);
        mark.symbol = kByHeight[i];
        const std::string from = told_value(plot.z, thirds[i].low);
        mark.name = told[i] ? ""
                    : thirds[i].low < thirds[i].high
                        ? phrase("{0} to {1}", from, told_value({"", false}, thirds[i].high)).in(language)
                        : from;
        told[i] = true;
    }
    return false;
}

std::vector<ChartMark> marks_apart(const std::vector<PlotMark>& marks, const MarkGroups& groups, const AxisScale& across,
                                   const AxisScale& up, double radius, double gap, std::size_t& left_out, std::size_t& repeated) {
    const auto place = [&](const PlotMark& mark) { return Point{across.at(mark.x), up.at(mark.y)}; };
    std::vector<ChartMark> drawn;
    std::array<std::vector<const PlotMark*>, kSymbols> others;
    Box box = kNothing;
    for (const PlotMark& mark : marks) box.take(place(mark));
    const double widest = 2 * std::max(reach_of(PlotSymbol::square, radius), reach_of(PlotSymbol::triangle, radius)) + gap;
    Places places(box, widest);
    const auto draw = [&](const PlotMark& mark) {
        drawn.push_back({&mark, place(mark)});
        places.add(place(mark));
    };
    for (const PlotMark& mark : marks)
        if (mark.name.empty() || groups.has(mark.symbol))
            others[index_of(mark.symbol)].push_back(&mark);
        else
            draw(mark);
    std::size_t longest = 0;
    for (const auto& group : others) longest = std::max(longest, group.size());
    for (std::size_t i = 0; i < longest; ++i)
        for (const auto& group : others) {
            if (i >= group.size()) continue;
            const PlotMark& mark = *group[i];
            const Point at = place(mark);
            bool same = false;
            const bool near = places.any_near(at, widest, [&](std::size_t k) {
                same = same || (drawn[k].mark->x == mark.x && drawn[k].mark->y == mark.y);
                return same ||
                       distance(drawn[k].at, at) < reach_of(mark.symbol, radius) + reach_of(drawn[k].mark->symbol, radius) + gap;
            });
            if (!near) {
                draw(mark);
                continue;
            }
            ++left_out;
            repeated += same ? 1 : 0;
        }
    return drawn;
}

}  // namespace tactics
