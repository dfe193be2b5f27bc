// SPDX-License-Identifier: Apache-2.0
#include "filters/surface_sections.h"

#include <algorithm>
#include <cmath>

#include "filters/chart_axis.h"
#include "tactics/error.h"
#include "tactics/geometry/line_styles.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr int kMostSections = static_cast<int>(kLineStyles);

// At `place` between the samples of one line across the surface.
double height_at(const std::vector<double>& samples, double place, auto height) {
    const auto above = std::lower_bound(samples.begin(), samples.end(), place);
    const auto i = static_cast<std::size_t>(above - samples.begin());
    if (i < samples.size() && samples[i] == place) return height(i);
    const double share = (place - samples[i - 1]) / (samples[i] - samples[i - 1]);
    return height(i - 1) + share * (height(i) - height(i - 1));
}

}  // namespace

Plot sections_of(const Plot& plot, const PlotSurface& surface, const SectionWish& wish) {
    const std::vector<double>&along = wish.at_x ? surface.y : surface.x, &cut = wish.at_x ? surface.x : surface.y;
    const Axis& axis = wish.at_x ? plot.x : plot.y;
    std::vector<double> at = wish.at;
    if (at.empty()) at = axis_ticks(axis, {cut.front(), cut.back()}, kMostSections).ticks.at;
    if (at.size() > static_cast<std::size_t>(kMostSections))
        throw Error(Fault::usage, spelled("section"),
                    phrase("a finger tells {0} curves from each other, and {1} sections are named; name fewer",
                           std::to_string(kMostSections), std::to_string(at.size())));
    Plot sections{plot.title, wish.at_x ? plot.y : plot.x, plot.z, {}, {}};
    for (const double place : at) {
        if (!(place >= cut.front() && place <= cut.back())) {
            if (wish.at.empty()) continue;
            throw Error(Fault::usage, spelled("section"),
                        phrase("{0} is beside the surface, which goes from {1} to {2}", numeral(place), numeral(cut.front()),
                               numeral(cut.back())));
        }
        PlotCurve curve{told_value(axis, place), {}};
        bool known = true;
        for (std::size_t i = 0; i < along.size(); ++i) {
            const double z =
                height_at(cut, place, [&](std::size_t k) { return wish.at_x ? surface.at(k, i) : surface.at(i, k); });
            if (std::isnan(z)) {
                known = false;
                continue;
            }
            if (!known && !curve.points.empty()) curve.gaps.push_back(curve.points.size());
            known = true;
            curve.points.push_back({along[i], z});
        }
        if (!curve.points.empty()) sections.curves.push_back(std::move(curve));
    }
    return sections;
}

}  // namespace tactics
