// SPDX-License-Identifier: Apache-2.0
// Where names of axes go.
#include "tactics/job/axis_names.h"

#include <gtest/gtest.h>

#include <utility>

namespace tactics::axis_names_test {
namespace {

PrintPlace number(double x, double y) { return {{x, y}, 3, false, true}; }
PrintPlace upwards(double x, double y) { return {{x, y}, 3, true}; }

TEST(AxisNames, OfAnUprightAxisStandsAboveItsNumbers) {
    std::vector<PrintPlace> places{number(8, 10), number(8, 50), number(8, 90), upwards(2, 50), number(60, 4)};
    place_axis_names(places, 100);
    EXPECT_LT(places[3].at.y, 10 - 3);  // clear of the topmost of its own, not of one far away
    EXPECT_GT(places[3].at.x, 2);
    EXPECT_LT(places[3].at.x, 8);
    EXPECT_TRUE(places[3].loose);
    EXPECT_FALSE(places[0].loose);
}

TEST(AxisNames, WithoutNumbersOnBothSidesStaysWhereItIs) {
    std::vector<PrintPlace> alone{upwards(2, 50), number(60, 10), number(60, 90)};
    place_axis_names(alone, 100);
    EXPECT_EQ(std::pair(alone[0].at.x, alone[0].at.y), std::pair(2.0, 50.0));
    std::vector<PrintPlace> above{upwards(2, 50), number(8, 60), number(8, 90)};
    place_axis_names(above, 100);
    EXPECT_EQ(std::pair(above[0].at.x, above[0].at.y), std::pair(2.0, 50.0));
}

TEST(AxisNames, NumbersThatRunUpwardsAreTheNumbersOfTheAxis) {
    std::vector<PrintPlace> places{upwards(8, 10), upwards(8, 50), upwards(8, 90), upwards(2, 50)};
    for (int i = 0; i < 3; ++i) places[static_cast<std::size_t>(i)].number = true;
    place_axis_names(places, 100);
    EXPECT_LT(places[3].at.y, 10 - 3);
    EXPECT_EQ(places[1].at.y, 50);
    EXPECT_FALSE(places[1].loose);
}

TEST(AxisNames, AloneAtTheSideMayStandAnywhereNearIt) {
    std::vector<PrintPlace> axis{upwards(4, 50), {{50, 96}, 3}};
    place_axis_names(axis, 100);
    EXPECT_TRUE(axis[0].loose);
    std::vector<PrintPlace> columns{upwards(10, 50), upwards(22, 50), upwards(34, 50)};  // each names its own thing
    place_axis_names(columns, 100);
    for (const PrintPlace& name : columns) EXPECT_FALSE(name.loose);
}

TEST(AxisNames, OfALevelAxisStandsLowerWhenARowOfNumbersIsCloseAboveIt) {
    std::vector<PrintPlace> row{number(10, 90), number(50, 90), number(90, 90), {{50, 96}, 3}};
    place_axis_names(row, 100);
    EXPECT_GT(row[3].at.y, 96 + 3);
    EXPECT_EQ(row[3].at.x, 50);
    EXPECT_TRUE(row[3].loose);
    std::vector<PrintPlace> two{number(10, 90), number(50, 90), {{50, 96}, 3}};  // no row
    std::vector<PrintPlace> far{number(10, 80), number(50, 80), number(90, 80), {{50, 96}, 3}};
    for (auto* places : {&two, &far}) {
        place_axis_names(*places, 100);
        EXPECT_EQ(std::pair(places->back().at.x, places->back().at.y), std::pair(50.0, 96.0));
        EXPECT_FALSE(places->back().loose);
    }
}

}  // namespace
}  // namespace tactics::axis_names_test
