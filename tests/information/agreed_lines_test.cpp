// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/agreed_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tactics/information/entropy.h"

namespace tactics::agreed_lines_test {
namespace {

constexpr double kNoLimit = 1e9;

AgreedLines page(double drawn, double agreed, double wanted, double room = 10'000, double followed = kNoLimit) {
    return {drawn, agreed, wanted, room, followed};
}

// Every place as a cell of two grids, counted by what counts cells.
double counted(int drawn, int agreed, int wanted, int room) {
    std::vector<std::uint8_t> on_page, people;
    for (int i = 0; i < room; ++i) {
        on_page.push_back(i < drawn ? 1 : 0);
        people.push_back(i < agreed || (i >= drawn && i < drawn + wanted - agreed) ? 1 : 0);
    }
    const JointEntropy joint = joint_entropy({room, 1, 1, 2, on_page}, {room, 1, 1, 2, people});
    return joint.first.plug_in + joint.second.plug_in - joint.joint.plug_in;
}

TEST(AgreedLines, AreTheMutualInformationOfTheirPlaces) {
    for (const auto& [drawn, agreed, wanted] : {std::array{400, 300, 500}, {400, 400, 400}, {1000, 200, 900}, {50, 1, 700}})
        EXPECT_NEAR(agreed_bits(page(drawn, agreed, wanted)).carried, counted(drawn, agreed, wanted, 10'000), 1e-9)
            << drawn << " " << agreed << " " << wanted;
}

TEST(AgreedLines, LoseNothingWhereAllAgreeAndAllWhereNoneDoes) {
    EXPECT_NEAR(agreed_bits(page(800, 800, 800)).loss(), 0, 1e-9);
    EXPECT_EQ(agreed_bits(page(0, 0, 800)).loss(), 1);
    EXPECT_NEAR(agreed_bits(page(1000, 80, 800)).loss(), 1, 1e-9) << "as many as by chance";
    EXPECT_EQ(agreed_bits(page(0, 0, 0)).loss(), 1) << "there is nothing to tell";
    EXPECT_EQ(agreed_bits(page(5, 5, 5, 0)).loss(), 1) << "there is no room";
}

// What chooses by the bits of a page alone draws everything.
TEST(AgreedLines, ClutterTellsLess) {
    double last = agreed_bits(page(800, 700, 1000)).loss();
    for (double clutter = 200; clutter < 6000; clutter += 200) {
        const double loss = agreed_bits(page(800 + clutter, 700, 1000)).loss();
        EXPECT_GT(loss, last) << clutter;
        last = loss;
    }
    last = agreed_bits(page(100, 100, 1000)).loss();
    for (double more = 200; more <= 1000; more += 100) {
        const double loss = agreed_bits(page(more, more, 1000)).loss();
        EXPECT_LT(loss, last) << more;
        last = loss;
    }
}

TEST(AgreedLines, WhoFollowsLessIsToldLess) {
    double last = agreed_bits(page(2000, 1600, 2500)).loss();
    EXPECT_EQ(agreed_bits(page(2000, 1600, 2500, 10'000, 2000)).loss(), last);
    for (double followed = 1900; followed > 100; followed -= 100) {
        const double loss = agreed_bits(page(2000, 1600, 2500, 10'000, followed)).loss();
        EXPECT_GT(loss, last) << followed;
        last = loss;
    }
}

TEST(AgreedLines, AFullPageHasALineAtEachPlaceAndTellsNothing) {
    for (const double drawn : {10'000.0, 20'000.0}) EXPECT_NEAR(agreed_bits(page(drawn, 3000, 4000)).loss(), 1, 1e-9) << drawn;
}

}  // namespace
}  // namespace tactics::agreed_lines_test
