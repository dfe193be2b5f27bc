// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/chart.h"
#include "tactics/medium.h"

namespace tactics::play_report_test {
namespace {

// Onto a block of 40 mm, back and on it again: the finger climbs beside the wall, where the two lines are one to a fingertip.
std::vector<TickRecord> there_and_back(const HeightMap& map) {
    std::vector<TickRecord> records;
    double time = 0, finger = 8;
    const auto go = [&](double from, double to) {
        for (int i = 0; i <= 200; ++i) {
            const Point at{from + (to - from) * i / 200, 1};
            const double surface = map.at(static_cast<int>(at.x), 0);
            finger += std::clamp(surface - 1 - finger, -0.4, 0.4);
            records.push_back({time += 0.001, at, finger, surface, surface, {}, at});
        }
    };
    go(10, 60);
    go(60, 15);
    go(15, 70);
    return records;
}

HeightMap block() {
    HeightMap map{80, 4, 1, {}};
    for (int i = 0; i < 80 * 4; ++i) map.heights.push_back(i % 80 < 40 ? 8.0F : 48.0F);
    return map;
}

TEST(WayPlot, HasTheWholeWayOfTheFinger) {
    const HeightMap map = block();
    const ReliefSurface surface(map);
    const std::vector<TickRecord> records = there_and_back(map);
    const Plot plot = way_plot(records, surface, {}, false);
    EXPECT_EQ(plot.x.name, "way, mm");
    ASSERT_EQ(plot.curves.at(0).name, "fingertip");
    ASSERT_EQ(plot.curves[0].points.size(), records.size());
    EXPECT_NEAR(plot.curves[0].points.back().x, 50 + 45 + 55, 0.01);
    for (std::size_t i = 0; i < records.size(); ++i) EXPECT_EQ(plot.curves[0].points[i].y, records[i].finger);
    const Plot first = way_plot(records, surface, {}, true);
    EXPECT_EQ(first.x.name, "place, mm");
    EXPECT_NEAR(first.curves[0].points.back().x, 60, 1);
}

// On the page, too: the line of the finger is one piece.
TEST(WayPlot, DrawsTheClimbAtAWall) {
    const HeightMap map = block();
    const ReliefSurface surface(map);
    const Plot plot = way_plot(there_and_back(map), surface, {}, true);
    Sheet sheet;
    sheet.medium = &find_medium("swell", "test");
    sheet.paper = find_paper("A4", "test");
    const Drawing drawing = draw_chart(plot, sheet);
    double highest = INFINITY, lowest = -INFINITY;
    std::size_t pieces = 0;
    for (const Stroke& stroke : drawing.strokes) {
        if (stroke.role != Role::line || stroke.line != LineClass::normal) continue;
        if (pieces++ > 0) continue;
        for (const Point at : stroke.points) {
            highest = std::min(highest, at.y);
            lowest = std::max(lowest, at.y);
        }
    }
    EXPECT_GT(pieces, 1u);
    EXPECT_GT(lowest - highest, 80) << "mm on the page, of the first curve's first piece";
}

}  // namespace
}  // namespace tactics::play_report_test
