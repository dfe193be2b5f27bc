// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/arm_cut.h"

#include <cmath>
#include <utility>

#include "cli/chart_flags.h"
#include "filters/chart_contours.h"
#include "filters/contour_lines.h"
#include "filters/surface_levels.h"
#include "tactics/error.h"

namespace tactics {

namespace {

// The lines in mm of the field, a level each.
std::vector<ChartLevel> felt_levels(const Plot& levels, const PlotSurface& surface, Point field) {
    const auto share = [](double at, const std::vector<double>& along) {
        return (at - along.front()) / (along.back() - along.front());
    };
    std::vector<ChartLevel> felt;
    for (const PlotCurve& curve : levels.curves) {
        ChartLevel level;
        auto gap = curve.gaps.begin();
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const bool begins = i == 0 || (gap != curve.gaps.end() && *gap == i);
            if (begins && i > 0) ++gap;
            if (begins) level.lines.emplace_back();
            level.lines.back().push_back(
                {field.x * share(curve.points[i].x, surface.x), field.y * share(curve.points[i].y, surface.y)});
        }
        felt.push_back(std::move(level));
    }
    return felt;
}

// As many as a finger can tell apart, as on paper: at most a third of the lines is near one of another level.
Plot chosen_levels(const Plot& plot, const PlotSurface& surface, int wanted, Point field) {
    if (wanted > 0) return levels_of(plot, surface, contour_levels(surface, wanted));
    Plot levels;
    for (int most = kMostContourLevels; most >= kFewestLevels; --most) {
        levels = levels_of(plot, surface, contour_levels(surface, most));
        if (share_near(felt_levels(levels, surface, field)) <= kMostNear) break;
    }
    return levels;
}

}  // namespace

CutWish cut_wish(const Given& given) {
    CutWish wish;
    if (given.has("--levels")) wish.levels = levels_value(given);
    if (given.has("--section")) wish.section = section_value(given);
    if (wish.levels && wish.section)
        throw Error(Fault::usage, "--section",
                    phrase("contours and sections do not share axes; leave out one of --levels and --section"));
    return wish;
}

Plot cut_of(const Plot& plot, const CutWish& wish, Point field, const std::string& name, std::vector<Phrase>& told) {
    const char* flag = wish.levels ? "--levels" : "--section";
    if (plot.surfaces.empty())
        throw Error(Fault::usage, flag,
                    phrase("it is about a surface, and {0} has none; of a table, name its heights with --z", name));
    const PlotSurface& surface = plot.surfaces.front();
    Plot cut = wish.levels ? chosen_levels(plot, surface, *wish.levels, field) : sections_of(plot, surface, *wish.section);
    if (cut.curves.empty())
        throw Error(Fault::usage, flag,
                    wish.levels ? phrase("the surface is level, and has no lines of equal height; leave it out")
                                : phrase("nothing is known of the surface there; take another place"));
    std::string names;
    for (const PlotCurve& curve : cut.curves) names += (names.empty() ? "" : ", ") + curve.name;
    told.push_back(wish.levels ? phrase("felt as lines of equal height: {0}", names) : phrase("felt cut open: {0}", names));
    return cut;
}

}  // namespace tactics
