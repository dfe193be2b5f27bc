// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study repair` as the user meets it.
#include <gtest/gtest.h>

#include "tests/studies/evaluating.h"

namespace tactics::repair_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

class EvaluateRepair : public testing::Test {
protected:
    EvaluateRepair() {
        fs::create_directories(folder / "set/images");
        fs::create_directories(folder / "set/gt");
        // Rows of lines, each of them what a person drew.
        const auto lines = [](int apart) {
            return [apart](int x, int y) { return x > 20 && x < 180 && y % apart == apart / 2; };
        };
        write_bytes(folder / "set/images/far.png", png(200, 160, lines(20)));
        write_bytes(folder / "set/gt/far_gt1.png", png(200, 160, [&](int x, int y) { return !lines(20)(x, y); }));
        write_bytes(folder / "set/images/near.png", png(200, 160, lines(3)));
        write_bytes(folder / "set/gt/near_gt1.png", png(200, 160, [&](int x, int y) { return !lines(3)(x, y); }));
    }
    Ending study(Words words) {
        words.insert(words.begin(), {"evaluate", "set", "--study", "repair", "-f", "threshold", "-f", "trace shortest=0"});
        return run_tactics(folder, words);
    }
    Folder folder;
};

TEST_F(EvaluateRepair, TellsWhatMendingTakesAndLeaves) {
    const Ending table = study({});
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_TRUE(holds(table.out, "places before  places after  not legible  R before  R after")) << table.out;
    const std::string json = study({"--json"}).out;
    EXPECT_TRUE(holds(json, R"("picture":"far","hard_before":0,"hard_after":0,"legible":true,"kept":1,)")) << json;
    const auto near = json.find("\"picture\":\"near\"");
    ASSERT_NE(near, std::string::npos);
    EXPECT_FALSE(holds(json.substr(near), "\"hard_before\":0,")) << json;
    EXPECT_TRUE(holds(json.substr(near), "\"hard_after\":0,")) << json;
}

TEST_F(EvaluateRepair, DrawsAChartAndRefusesWhatItHasNot) {
    EXPECT_EQ(study({"--chart", "c.svg", "-q"}).code, 0);
    EXPECT_TRUE(fs::exists(folder / "c.svg"));
    EXPECT_EQ(study({"--csv", "c.csv"}).code, 1);
    EXPECT_EQ(study({"--sweep", "threshold.level=1,2"}).code, 1);
}

}  // namespace
}  // namespace tactics::repair_test
