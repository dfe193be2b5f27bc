// SPDX-License-Identifier: Apache-2.0
#include "filters/surface_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/chart.h"
#include "filters/contour_lines.h"

namespace tactics::surface_levels_test {
namespace {

Plot two_hills() {
    Plot plot{"", {"east, km"}, {"north, km"}, {}, {}};
    plot.z = {"height (m)"};
    PlotSurface surface;
    for (int i = 0; i <= 40; ++i) surface.x.push_back(i / 10.0 - 2);
    for (int j = 0; j <= 30; ++j) surface.y.push_back(j / 10.0 - 1.5);
    for (const double y : surface.y)
        for (const double x : surface.x)
            surface.z.push_back(100 * std::exp(-4 * ((x - 1) * (x - 1) + y * y)) +
                                60 * std::exp(-4 * ((x + 1) * (x + 1) + y * y)));
    plot.surfaces.push_back(std::move(surface));
    return plot;
}

// Between samples the height is linear along the sides of their squares, on which all points lie.
double height_at(const PlotSurface& surface, PlotPoint at) {
    const auto cell = [](const std::vector<double>& along, double place) {
        const auto above = std::upper_bound(along.begin() + 1, along.end() - 1, place);
        return static_cast<std::size_t>(above - along.begin()) - 1;
    };
    const std::size_t i = cell(surface.x, at.x), k = cell(surface.y, at.y);
    const double u = (at.x - surface.x[i]) / (surface.x[i + 1] - surface.x[i]),
                 v = (at.y - surface.y[k]) / (surface.y[k + 1] - surface.y[k]);
    return (1 - v) * ((1 - u) * surface.at(i, k) + u * surface.at(i + 1, k)) +
           v * ((1 - u) * surface.at(i, k + 1) + u * surface.at(i + 1, k + 1));
}

TEST(SurfaceLevels, EachCurveIsAtItsHeightAndNamedByIt) {
    const Plot plot = two_hills();
    const Plot levels = levels_of(plot, plot.surfaces.front(), {20, 40, 80, 500});
    ASSERT_EQ(levels.curves.size(), 3u);  // nothing is as high as 500
    const double heights[] = {20, 40, 80};
    const std::size_t lines[] = {2, 2, 1};  // the lower hill has no 80
    for (std::size_t i = 0; i < 3; ++i) {
        const PlotCurve& curve = levels.curves[i];
        EXPECT_EQ(curve.name, "height = " + std::to_string(static_cast<int>(heights[i])) + " m");
        EXPECT_EQ(curve.gaps.size() + 1, lines[i]);
        for (const PlotPoint& at : curve.points) EXPECT_NEAR(height_at(plot.surfaces.front(), at), heights[i], 1e-9);
        // Round a hill and back.
        const std::size_t end = curve.gaps.empty() ? curve.points.size() : curve.gaps.front();
        EXPECT_EQ(curve.points.front().x, curve.points[end - 1].x);
        EXPECT_EQ(curve.points.front().y, curve.points[end - 1].y);
    }
    EXPECT_EQ(levels.x.name, "east, km");
    EXPECT_TRUE(levels.surfaces.empty());
}

// What is nearer to the reader is further down, and its ticks with it.
TEST(Chart, AnAxisMayGrowDownwards) {
    Plot plot{"", {"x"}, {"towards you, mm"}, {}, {}};
    plot.marks = {{"", 1, 0}, {"", 2, 30}};
    const Sheet sheet = [] {
        Sheet made;
        made.paper = find_paper("a4", "");
        made.medium = &find_medium("swell", "");
        return made;
    }();
    const auto far_below = [&] {
        const Drawing drawing = draw_chart(plot, sheet);
        double zero = 0, thirty = 0;
        for (const Label& label : drawing.labels) {
            if (label.text == "0" && label.across == 1) zero = label.at.y;
            if (label.text == "30" && label.across == 1) thirty = label.at.y;
        }
        EXPECT_GT(zero, 0);
        EXPECT_GT(thirty, 0);
        return thirty - zero;
    };
    EXPECT_LT(far_below(), -50);
    plot.y.downwards = true;
    EXPECT_GT(far_below(), 50);
}

}  // namespace
}  // namespace tactics::surface_levels_test
