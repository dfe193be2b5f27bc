// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study page` as the user meets it.
#include "studies/page.h"

#include <gtest/gtest.h>

#include "tactics/text/table.h"
#include "tests/studies/evaluating.h"

namespace tactics::page_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

class EvaluatePage : public testing::Test, public OutlinedRectangle {
protected:
    // One drew something besides.
    EvaluatePage() : OutlinedRectangle(3) {
        add_person(4, [](int x, int y) { return x == 50 || outline(x, y); });
    }
};

TEST_F(EvaluatePage, AWholeOutlineThatAllDrewIsAllThatIsWanted) {
    const Ending json = study("page", {"-q", "--json", "-r", "sobel"});
    EXPECT_EQ(json.code, 0) << json.err;
    EXPECT_TRUE(holds(json.out, R"({"recipe":"sobel","scored":1,"p3":1,"p1":1,"r3":1,"main_object":1,)")) << json.out;
    EXPECT_TRUE(holds(json.out, R"("lines":1,)")) << json.out;
    EXPECT_TRUE(holds(json.out, R"("loose_ends":0,"whole":1,)")) << json.out;
    EXPECT_TRUE(holds(json.out, R"({"recipe":"simplest person","scored":1,"p3":1,"p1":1,"r3":1,"main_object":1,)")) << json.out;
    EXPECT_TRUE(holds(json.out, R"({"study":"page","pictures":1,"problems":[]})")) << json.out;
    const Ending table = study("page", {"-q", "-r", "sobel"});
    EXPECT_TRUE(
        table.out.starts_with("recipe              P3     P1     R3  main object  diagonals  lines  line mm  loose ends  whole"))
        << table.out;
    EXPECT_TRUE(holds(table.out, "\nsobel            1.000  1.000  1.000        1.000 ")) << table.out;
    EXPECT_TRUE(holds(table.out, "\nsimplest person  1.000  1.000  1.000        1.000 ")) << table.out;
}

TEST_F(EvaluatePage, APageWithoutLinesHasNothing) {
    write_bytes(folder / "set/images/a.png", png(kWidth, kHeight, [](int, int) { return false; }));
    EXPECT_TRUE(holds(study("page", {"-q", "-r", "sobel"}).out, "\nsobel            0.000  0.000  0.000        0.000 "));
}

// A page that a person drew, by the maps of what it shows, in the size of those.
TEST_F(EvaluatePage, AFigureIsScoredAsItIs) {
    fs::remove(folder / "set/images/a.png");
    const auto figure = [&](int left, int right) {
        write_bytes(folder / "set/images/a.svg",
                    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 300' fill='none' stroke='black'><rect x='" +
                        std::to_string(left) + "' y='80' width='" + std::to_string(right - left) + "' height='140'/></svg>");
        return study("page", {"-q", "--json", "-r", "sobel"});
    };
    const Ending right = figure(kLeft, kRight), half = figure(kLeft, (kLeft + kRight) / 2);
    EXPECT_EQ(right.code, 0) << right.err;
    EXPECT_TRUE(holds(right.out, R"("scored":1,"p3":1,"p1":1,"r3":1,"main_object":1,)")) << right.out;
    EXPECT_EQ(half.code, 0) << half.err;
    EXPECT_FALSE(holds(half.out, R"({"recipe":"sobel","scored":1,"p3":1,)")) << half.out;
    EXPECT_TRUE(holds(study("contours", {}).err, "there is no study")) << "it is the plain command";
    EXPECT_EQ(run_tactics(folder, {"evaluate", "set", "-r", "sobel", "-q"}).code, 0);
    EXPECT_TRUE(holds(study("subject", {"-r", "sobel"}).err, "it is no picture, in which things could be looked for"));
}

TEST_F(EvaluatePage, WritesAChartForEachShareAndATable) {
    EXPECT_EQ(study("page", {"-q", "-r", "sobel", "-r", "photo", "--chart", "c.svg", "--csv", "t.csv"}).code, 0);
    EXPECT_TRUE(holds(bytes_of(folder / "c-p3.svg"), "simplest person"));
    EXPECT_TRUE(fs::exists(folder / "c-r3.svg"));
    EXPECT_FALSE(fs::exists(folder / "c.svg"));
    EXPECT_TRUE(bytes_of(folder / "t.csv").starts_with("recipe,P3,P1,R3,"));
    EXPECT_EQ(study("page", {"-r", "sobel", "--sweep", "sobel.blur=1mm,2mm"}).code, 1);
}

TEST_F(EvaluatePage, APictureWithoutMapsIsNamed) {
    write_bytes(folder / "set/images/bare.png", png(40, 30, [](int x, int) { return x < 9; }));
    const Ending ending = study("page", {"-q", "-r", "sobel"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "images/bare.png: it has no contour map")) << ending.err;
    EXPECT_TRUE(holds(ending.out, "     1  1\n")) << ending.out;
}

PageTrial trial(double p3, std::optional<double> r3, double length, double whole, double ms) {
    PageTrial made;
    made.tried = true;
    made.shares.p3 = p3;
    made.shares.r3 = r3;
    made.lines.length = length;
    made.lines.whole = whole;
    made.page_ms = ms;
    return made;
}

TEST(PageFigures, AreMeansOfSharesAndMediansOfTheRest) {
    const PageMaker maker{"a", true, {trial(0.5, 1, 100, 50, 1), trial(1, std::nullopt, 300, 300, 9), {}, trial(0, 0, 0, 0, 2)}};
    const PageFigures figures = page_figures(maker);
    EXPECT_EQ(figures.pages, 3u);
    EXPECT_DOUBLE_EQ(figures.p3, 0.5);
    EXPECT_DOUBLE_EQ(figures.r3.value(), 0.5);  // of those that have contours to agree on
    EXPECT_DOUBLE_EQ(figures.whole, 0.5);
    EXPECT_DOUBLE_EQ(figures.length, 100);
    EXPECT_DOUBLE_EQ(figures.page_ms, 2);
}

TEST(PageFigures, WhatNoPictureHasIsNotNought) {
    PageTrial without = trial(0.5, std::nullopt, 100, 50, 1), nobody, failed;
    nobody.nobody = true;
    const PageStudy study{{"a", "b", "c"}, {{"photo", true, {without, nobody, failed}}}, {}};
    EXPECT_FALSE(page_figures(study.makers[0]).r3);
    EXPECT_FALSE(page_figures(study.makers[0]).main_object);
    const std::vector<ToldRow> rows = page_rows(study);
    EXPECT_EQ(rows[1][1].english(), "0.500");
    EXPECT_EQ(rows[1][3].english(), "");
    EXPECT_EQ(rows[1][4].english(), "");
    EXPECT_EQ(rows[1][11].english(), "1");
    EXPECT_EQ(rows[1][12].english(), "1") << "a picture of which one person's lines are all there is, is no failure";
    EXPECT_EQ(page_json(study).find("\"r3\""), std::string::npos);
    EXPECT_TRUE(page_plot(study, true).marks.empty());
    EXPECT_EQ(page_plot(study, false).marks.size(), 1u);
}

// What is expected beside what is, the pages that are told first; whether one is poor is the people's word, not the recipe's.
TEST(PageFigures, WhatWasExpectedStandsBesideWhatIs) {
    PageStudy study{{"a", "b", "c"}, {}, {}};
    PageTrial low = trial(0.4, 0.3, 1, 1, 1), high = trial(0.9, 0.8, 1, 1, 1), silent = trial(0.9, 0.9, 1, 1, 1);
    low.trust = {0.5, 0.5};
    low.poor = true;
    high.trust = {0.9, 0.7};
    study.makers.push_back({"photo", true, {low, high, silent}});
    study.makers.push_back({"sobel", true, {silent, silent, silent}});
    PageTrial nothing = high;  // that anybody would draw: no share of it
    nothing.shares.r3.reset();
    nothing.trust = {0.9, 0.9};
    study.makers[0].trials.push_back(nothing);
    const std::vector<ToldRow> rows = trust_rows(study);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(in_language(rows[1], "en"), (Row{"photo", "too little, told", "1", "1", "0.500", "0.400", "0.500", "0.300"}));
    EXPECT_EQ(in_language(rows[2], "en"), (Row{"photo", "more", "2", "0", "0.900", "0.900", "0.700", "0.800"}));
}

TEST(PageFigures, TheChartHasTheFrontierAndTheLevelOfAPerson) {
    PageStudy study{{"p"}, {}, {}};
    study.makers.push_back({"slow", true, {trial(0.4, 0.9, 1, 1, 30)}});
    study.makers.push_back({"good", true, {trial(0.8, 0.2, 1, 1, 20)}});
    study.makers.push_back({"simplest person", false, {trial(0.95, 0.7, 1, 1, 0)}});
    const Plot precision = page_plot(study, false), recall = page_plot(study, true);
    ASSERT_EQ(precision.marks.size(), 2u);
    EXPECT_EQ(precision.marks[0].name, "good");
    EXPECT_EQ(precision.marks[0].symbol, PlotSymbol::disc);
    EXPECT_EQ(precision.marks[1].symbol, PlotSymbol::ring);
    EXPECT_TRUE(recall.marks[0].symbol == PlotSymbol::disc && recall.marks[1].symbol == PlotSymbol::disc);
    ASSERT_EQ(precision.curves.size(), 2u);
    EXPECT_EQ(precision.curves[1].name, "simplest person");
    for (const PlotPoint& point : precision.curves[1].points) EXPECT_DOUBLE_EQ(point.y, 0.95);
    EXPECT_DOUBLE_EQ(recall.curves[1].points[0].y, 0.7);
}

}  // namespace
}  // namespace tactics::page_test
