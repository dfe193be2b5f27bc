// SPDX-License-Identifier: Apache-2.0
// What `convert` says of the heights of lines, on machines whose dots have several.
#include <set>

#include "tests/cli/converting.h"

namespace tactics::tests::told_heights_test {
namespace {

class ToldHeights : public Convert {
protected:
    ToldHeights() { write_bytes(folder / "rain.csv", "day,rain\n1,3\n2,7\n3,4\n4,9\n5,1\n"); }
    Ending page(Words more) {
        Words words{"rain.csv", "-o", "viewplus:rain.png"};
        words.insert(words.end(), more.begin(), more.end());
        return convert(words);
    }
};

TEST_F(ToldHeights, SaysHowManyAreUsedAndWhatFewerLose) {
    const Ending told = page({});
    ASSERT_EQ(told.code, 0) << told.err;
    EXPECT_TRUE(holds(told.err,
                      "rain.csv: viewplus has 2 heights, and 2 are used (the drawing and braille: 100 %, axes, ticks and "
                      "lead lines: 50 %), which lose the least of the bits about what a line is for (losses by number of "
                      "heights: 1: 100 %, 2: 0 %)"))
        << told.err;
    const Ending json = page({"--json"});
    EXPECT_TRUE(
        holds(json.out, "\"heights\":{\"used\":2,\"most\":2,\"loss\":0,\"losses\":[1,0],\"kinds\":{\"drawn\":1,\"values\":0.5}}"))
        << json.out;
}

// Sheets of one chart tell one choice, and whoever has the page described hears of it.
TEST_F(ToldHeights, AreThoseOfAllSheetsAndAreDescribed) {
    const Ending tiled = convert({"rain.csv", "-o", "viewplus:sheets.png", "--tiles", "2x1", "--json"});
    ASSERT_EQ(tiled.code, 0) << tiled.err;
    std::set<std::string> choices;
    for (std::size_t at = tiled.out.find("\"heights\":"); at != std::string::npos; at = tiled.out.find("\"heights\":", at + 1))
        choices.insert(tiled.out.substr(at, tiled.out.find("}}", at) - at));
    EXPECT_EQ(choices.size(), 1u) << tiled.out;
    const Ending words = run_tactics(folder, {"describe", "rain.csv", "--embosser", "viewplus"});
    ASSERT_EQ(words.code, 0) << words.err;
    EXPECT_TRUE(holds(words.out, "Heights of what is raised: the drawing and braille: 100 %, axes, ticks and lead lines: 50 %."))
        << words.out;
    EXPECT_TRUE(holds(run_tactics(folder, {"describe", "rain.csv", "--embosser", "viewplus", "--set", "viewplus.axes=80"}).out,
                      "axes, ticks and lead lines: 80 %"));
    EXPECT_FALSE(holds(run_tactics(folder, {"describe", "rain.csv"}).out, "Heights"));
}

TEST_F(ToldHeights, HeightsThatTheUserSetsAreKept) {
    const Ending told = page({"--set", "viewplus.axes=80", "--json"});
    ASSERT_EQ(told.code, 0) << told.err;
    EXPECT_FALSE(holds(told.out, "\"heights\"")) << told.out;
    EXPECT_FALSE(holds(page({"--set", "viewplus.axes=80"}).err, "heights")) << told.err;
}

TEST_F(ToldHeights, LinesOfOneKindAreTalkedOfOnlyWhereBestIsAsked) {
    const Ending plain = convert({"disc.tif", "-r", "photo", "-o", "viewplus:disc.png"});
    ASSERT_EQ(plain.code, 0) << plain.err;
    EXPECT_FALSE(holds(plain.err, "heights")) << plain.err;
    const Ending best = convert({"disc.tif", "-r", "photo", "--detail", "best", "-o", "viewplus:disc.png"});
    EXPECT_TRUE(holds(best.err, "viewplus has 2 heights, and 1 is used: all lines are of one kind")) << best.err;
    // Swell paper has one height, of which nothing is to be said.
    EXPECT_FALSE(holds(convert({"rain.csv", "-o", "rain.pdf"}).err, "heights"));
}

}  // namespace
}  // namespace tactics::tests::told_heights_test
