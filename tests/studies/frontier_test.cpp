// SPDX-License-Identifier: Apache-2.0
// Charts of an evaluation, as the user meets them.
#include "studies/frontier.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/studies/discs.h"

namespace tactics::frontier_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;
TEST(Frontier, HoldsWhatNoneBeats) {
    std::mt19937 random(3);
    for (int i = 0; i < 500; ++i) {
        std::vector<PlotPoint> points(1 + random() % 12);
        for (PlotPoint& point : points) point = {static_cast<double>(random() % 6), static_cast<double>(random() % 6)};
        const std::vector<bool> best = on_frontier(points);
        ASSERT_EQ(best.size(), points.size());
        for (std::size_t a = 0; a < points.size(); ++a) {
            bool beaten = false;
            for (const PlotPoint& b : points)
                beaten = beaten || (b.x <= points[a].x && b.y >= points[a].y && (b.x < points[a].x || b.y > points[a].y));
            EXPECT_EQ(best[a], !beaten) << i << ": " << points[a].x << ", " << points[a].y;
        }
    }
}

TEST(Frontier, ThePlotJoinsItsMarks) {
    Evaluation evaluation;
    const auto add = [&](const std::string& name, long long found, double ms) {
        Trial trial;
        trial.curve.assign(levels().size(), Counts{found, 100, found, 100});
        trial.whole_ms = ms;
        evaluation.recipes.push_back({name, {""}, {{trial}}});
    };
    evaluation.pictures = {"a"};
    add("slow", 40, 30);
    add("good", 80, 20);
    add("quick", 30, 2);
    Trial failed;
    failed.error = "no";
    evaluation.recipes.push_back({"broken", {""}, {{failed}}});
    const Plot plot = frontier_plot(evaluation);
    ASSERT_EQ(plot.marks.size(), 3u);
    EXPECT_TRUE(plot.x.logarithmic);
    EXPECT_EQ(plot.marks[0].name, "quick");
    EXPECT_EQ(plot.marks[2].name, "slow");
    EXPECT_TRUE(plot.marks[0].symbol == PlotSymbol::disc && plot.marks[1].symbol == PlotSymbol::disc);
    EXPECT_EQ(plot.marks[2].symbol, PlotSymbol::ring);
    ASSERT_EQ(plot.curves.size(), 1u);
    ASSERT_EQ(plot.curves[0].points.size(), 2u);
    EXPECT_NEAR(plot.curves[0].points[1].y, 0.8, 1e-9);
}

TEST(Charts, AWordGoesBeforeTheEnding) {
    EXPECT_EQ(with_word("a.b/c.pdf", "dpi"), "a.b/c-dpi.pdf");
    EXPECT_EQ(with_word("a.b/c", "dpi"), "a.b/c-dpi");
}

using EvaluateCharts = EvaluateDiscs;

TEST_F(EvaluateCharts, AreWrittenInTheFormatsThatTheirNamesSay) {
    const Ending ending =
        evaluate({"-q", "-r", "photo", "-r", "sobel", "--chart", "c.svg", "--chart", "c.brf", "--chart", "png:c.x"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    const std::string svg = bytes_of(folder / "c.svg");
    for (const std::string_view words : {"Contours found, against time", "ms for a picture", "a sobel", "b photo"})
        EXPECT_TRUE(holds(svg, words)) << words;
    EXPECT_TRUE(holds(bytes_of(folder / "c.brf"), " PHOTO"));
    EXPECT_TRUE(bytes_of(folder / "c.x").starts_with("\x89PNG"));
    EXPECT_TRUE(holds(ending.out, "\nphoto")) << "the table stays: " << ending.out;
    const Ending named = evaluate({"-q", "-r", "sobel", "--chart", "d.svg", "--title", "My title", "--braille", "none"});
    EXPECT_EQ(named.code, 0) << named.err;
    EXPECT_TRUE(holds(bytes_of(folder / "d.svg"), "My title"));
}

TEST_F(EvaluateCharts, WhatCannotBeDrawnIsToldBeforeTheWork) {
    const auto refused = [&](const Words& words, std::string_view told) {
        const Ending ending = evaluate(words);
        EXPECT_EQ(ending.code, 1) << words.back();
        EXPECT_EQ(ending.out, "") << words.back();
        EXPECT_TRUE(holds(ending.err, told)) << ending.err;
        EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
    };
    refused({"--chart", "c.foo"}, "--chart c.foo: the ending .foo names no format");
    refused({"--chart", "pdf:-"}, "--chart: the results are written to standard output");
    refused({"--chart", "set/"}, "this is a folder");
    refused({"--chart", "c.pdf", "--chart", "c.pdf"}, "--chart: c.pdf is named twice");
    refused({"--chart", "c.pdf", "--paper", "100x90mm"}, "--chart c.pdf: ");
    refused({"--chart", "c.pdf", "--braille", "zz"}, "there is no braille table");
    refused({"--title", "x"}, "add --chart FILE");
    refused({"--study", "neded"}, "(needed?)");
    refused({"--study", "needed", "--csv", "c.csv"}, "--csv: ");
    refused({"--study", "needed", "--sweep", "kmeans.k=2"}, "--sweep: ");
}

TEST_F(EvaluateCharts, NothingScoredIsNothingDrawn) {
    for (const auto& file : fs::directory_iterator(folder / "set/gt")) write_bytes(file.path(), "no picture");
    const Ending ending = evaluate({"-q", "-r", "sobel", "--chart", "c.svg"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "nothing to draw")) << ending.err;
    EXPECT_FALSE(fs::exists(folder / "c.svg"));
    const Ending study = evaluate({"-q", "-r", "sobel", "--study", "needed", "--chart", "c.svg"});
    EXPECT_EQ(study.code, 2);
    EXPECT_TRUE(holds(study.err, "3 could not be scored:")) << study.err;
}

}  // namespace
}  // namespace tactics::frontier_test
