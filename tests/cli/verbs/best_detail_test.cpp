// SPDX-License-Identifier: Apache-2.0
// `--detail best`: how much line is chosen for a medium, and what is told of it.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "samples/draw/scenes.h"
#include "tests/cli/converting.h"
#include "tests/golden/golden.h"

namespace tactics::tests::best_detail_test {
namespace {

class BestDetail : public Convert {
protected:
    BestDetail() { golden::write_png(samples::draw_scene("balloon", 400), folder / "balloon.png"); }

    static double member(const std::string& json, const std::string& name, std::size_t from = 0) {
        const std::string before = "\"" + name + "\":";
        const std::size_t at = json.find(before, from);
        return at == std::string::npos ? -1 : std::atof(json.c_str() + at + before.size());
    }
};

TEST_F(BestDetail, IsTheLeastLossOfAllThatWereTriedAndThePageOfThatAmount) {
    const Ending told = convert({"balloon.png", "-r", "photo", "--detail", "best", "-o", "best.svg", "--json"});
    ASSERT_EQ(told.code, 0) << told.err;
    const std::size_t detail = told.out.find("\"detail\":");
    ASSERT_NE(detail, std::string::npos) << told.out;
    const double times = member(told.out, "times", detail), loss = member(told.out, "loss", detail);
    std::size_t tried = 0;
    double least = 1, last = 0;
    for (std::size_t at = told.out.find("{\"times\":", detail + 11); at != std::string::npos;
         at = told.out.find("{\"times\":", at + 1), ++tried) {
        EXPECT_GT(member(told.out, "times", at), last);
        last = member(told.out, "times", at);
        least = std::min(least, member(told.out, "loss", at));
        EXPECT_GE(member(told.out, "agreed", at), 0);
        EXPECT_LE(member(told.out, "agreed", at), 1);
        EXPECT_EQ(member(told.out, "broken", at), 0);
    }
    EXPECT_EQ(tried, 9u);
    EXPECT_NEAR(loss, least, 0.02);
    EXPECT_LT(loss, 1);
    ASSERT_EQ(convert({"balloon.png", "-r", "photo", "--detail", std::to_string(times), "-o", "same.svg", "-q"}).code, 0);
    const auto lines_of = [&](const std::string& name) {  // of the drawing, without the words about it
        std::string text = bytes_of(folder / name), lines;
        for (std::size_t at = text.find("<path"); at != std::string::npos; at = text.find("<path", at + 1))
            lines += text.substr(at, text.find('>', at) - at) + "\n";
        return lines;
    };
    EXPECT_FALSE(lines_of("best.svg").empty());
    EXPECT_EQ(lines_of("best.svg"), lines_of("same.svg"));
    EXPECT_EQ(convert({"balloon.png", "-r", "photo", "--detail", "best", "-o", "again.svg", "-q"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "best.svg"), bytes_of(folder / "again.svg"));
}

TEST_F(BestDetail, IsToldOfEachMedium) {
    const Ending told = convert(
        {"balloon.png", "-r", "photo", "--detail", "best", "-o", "page.pdf", "-o", "index-v4:page.prn", "-o", "page.txt"});
    ASSERT_EQ(told.code, 0) << told.err;
    EXPECT_TRUE(holds(told.err, "balloon.png: --detail best takes ")) << told.err;
    EXPECT_TRUE(holds(told.err, " for swell, which loses ")) << told.err;
    EXPECT_TRUE(holds(told.err, " for embosser, which loses ")) << told.err;
    EXPECT_TRUE(holds(told.err, "; of 9 amounts it is the nearest to the usual within 2 % of the least loss")) << told.err;
    EXPECT_TRUE(holds(bytes_of(folder / "page.txt"), "with which a page of this kind tells most of what people would draw."))
        << bytes_of(folder / "page.txt");
    EXPECT_TRUE(
        holds(run_tactics(folder, {"describe", "balloon.png", "-r", "photo", "--detail", "best"}).out, "It is drawn with "));
}

// The filter takes 100 m of line and no more.
TEST_F(BestDetail, TellsTheAmountsThatWereDrawn) {
    const Ending told =
        convert({"balloon.png", "-r", "photo", "--set", "outlines.line=60000", "--detail", "best", "-o", "best.svg", "--json"});
    ASSERT_EQ(told.code, 0) << told.err;
    std::vector<double> tried;
    for (std::size_t at = told.out.find("\"tried\":"); (at = told.out.find("{\"times\":", at)) != std::string::npos; ++at)
        tried.push_back(member(told.out, "times", at));
    EXPECT_EQ(tried.size(), 7u) << told.out;
    EXPECT_NEAR(tried.back(), 100.0 / 60, 1e-6);
}

TEST_F(BestDetail, IsForRecipesWhoseLinesHaveChances) {
    const Ending fast = convert({"balloon.png", "-r", "fast", "--detail", "best", "-o", "page.pdf"});
    EXPECT_EQ(fast.code, 1);
    EXPECT_TRUE(holds(fast.err, "recipe fast do not say how likely people would draw them")) << fast.err;
    const Ending map = convert({"balloon.png", "-r", "map", "--detail", "best", "-o", "page.pdf"});
    EXPECT_EQ(map.code, 1);
    EXPECT_TRUE(holds(map.err, "recipe map has no filter that keeps to a budget of line")) << map.err;
    EXPECT_TRUE(holds(convert({"balloon.png", "--detail", "bst", "-o", "page.pdf"}).err, "(best?)"));
    EXPECT_EQ(run_tactics(folder, {"evaluate", ".", "-r", "photo", "--detail", "best"}).code, 1);
}

// What auto draws whole has no amount to choose.
TEST_F(BestDetail, LeavesAPictureAloneThatIsDrawnWhole) {
    ASSERT_EQ(convert({"disc.tif", "--detail", "best", "-o", "best.svg"}).code, 0);
    ASSERT_EQ(convert({"disc.tif", "-o", "usual.svg"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "best.svg"), bytes_of(folder / "usual.svg"));
}

}  // namespace
}  // namespace tactics::tests::best_detail_test
