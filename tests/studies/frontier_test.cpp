// SPDX-License-Identifier: Apache-2.0
// Charts of an evaluation, and the study of what is needed, as the user meets them.
#include "studies/frontier.h"

#include <gtest/gtest.h>

#include <random>
#include <regex>

#include "samples/draw/files.h"
#include "tests/cli/tool.h"
#include "tests/filters/weights.h"

namespace tactics {
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
    EXPECT_TRUE(plot.marks[0].filled && plot.marks[1].filled);
    EXPECT_FALSE(plot.marks[2].filled);
    ASSERT_EQ(plot.curves.size(), 1u);
    ASSERT_EQ(plot.curves[0].points.size(), 2u);
    EXPECT_NEAR(plot.curves[0].points[1].y, 0.8, 1e-9);
}

TEST(Charts, AWordGoesBeforeTheEnding) {
    EXPECT_EQ(with_word("a.b/c.pdf", "dpi"), "a.b/c-dpi.pdf");
    EXPECT_EQ(with_word("a.b/c", "dpi"), "a.b/c-dpi");
}

// A dark disc on a ground, whose edge people drew, and a faint one that they left out.
class EvaluateCharts : public testing::Test {
protected:
    EvaluateCharts() {
        constexpr int kSide = 240;
        fs::create_directories(folder / "set/images");
        fs::create_directories(folder / "set/gt");
        for (const int radius : {40, 60, 80}) {
            Image picture = make_image(kSide, kSide, 1, 0, 0), map = make_image(kSide, kSide, 1, 0, 0);
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x) {
                    const double away = std::hypot(x - 120, y - 120) - radius;
                    const bool faint = std::hypot(x - 210, y - 30) < 22;
                    picture.row(y)[x] = static_cast<std::uint8_t>(away < 0 ? 40 : faint ? 160 : 200);
                    map.row(y)[x] = std::abs(away) < 0.5 ? 255 : 0;
                }
            const std::string name = "disc" + std::to_string(radius);
            samples::write_png(picture, (folder / ("set/images/" + name + ".png")).string());
            samples::write_png(map, (folder / ("set/gt/" + name + "_gt1.png")).string());
        }
    }

    Ending evaluate(Words words) {
        words.insert(words.begin(), {"evaluate", "set"});
        return run_tactics(folder, words);
    }

    Folder folder;
};

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

// The numbers after `name`, of the nth time that it occurs.
std::vector<double> numbers_after(const std::string& json, const std::string& name, std::size_t from = 0) {
    const auto at = json.find("\"" + name + "\":[", from);
    std::vector<double> numbers;
    if (at == std::string::npos) return numbers;
    const auto open = json.find('[', at), close = json.find(']', at);
    const std::string inside = json.substr(open + 1, close - open - 1);
    const std::regex number("[-0-9.e]+");
    for (std::sregex_iterator match(inside.begin(), inside.end(), number), end; match != end; ++match)
        numbers.push_back(std::stod(match->str()));
    return numbers;
}

TEST_F(EvaluateCharts, TheStudyOfWhatIsNeeded) {
    SKIP_WITHOUT_WEIGHTS();
    const Ending ending = evaluate({"-q", "--json", "-r", "photo", "-r", "none", "--study", "needed", "--chart", "n.svg"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    const std::string photo = ending.out.substr(0, ending.out.find('\n'));
    const auto own_f = [&](std::size_t from) { return std::stod(photo.substr(photo.find("\"own_f\":", from) + 8)); };
    // All of the grey levels of a grey picture, and all strokes, are the recipe as it is.
    std::size_t pictures = 0;
    for (std::size_t at = photo.find("{\"picture\":"); at != std::string::npos;
         at = photo.find("{\"picture\":", at + 1), ++pictures) {
        const std::size_t dial = photo.rfind("\"dial\":\"", at);
        const std::vector<double> f = numbers_after(photo, "f", at);
        if (photo.compare(dial + 8, 4, "dots") != 0) {
            EXPECT_NEAR(f.back(), own_f(at), 1e-4) << photo.substr(at, 300);
        }
        EXPECT_GT(f.back(), 0.5) << "a disc is found: " << photo.substr(at, 300);
        // Three greys are three, into however many more classes they are cut; in two the faint disc is gone.
        if (photo.compare(dial + 8, 4, "grey") == 0) {
            EXPECT_EQ(std::vector<double>(f.begin() + 1, f.end()), std::vector<double>(6, f.back())) << photo.substr(at, 300);
            EXPECT_GT(f.front(), f.back()) << photo.substr(at, 300);
        }
        // The faint strokes come last, and find nothing.
        if (photo.compare(dial + 8, 4, "stro") == 0) {
            EXPECT_GT(*std::max_element(f.begin(), f.end()), f.back()) << photo.substr(at, 300);
        }
    }
    EXPECT_EQ(pictures, 9u) << "three dials of three pictures";
    EXPECT_TRUE(std::regex_search(photo, std::regex("\"dial\":\"grey levels\".*\"needed_median\":2,"))) << photo;
    EXPECT_TRUE(fs::exists(folder / "n-levels.svg") && fs::exists(folder / "n-dpi.svg") && fs::exists(folder / "n-strokes.svg"));
    // A recipe that prints a picture has no strokes.
    EXPECT_TRUE(holds(ending.out.substr(photo.size()),
                      R"("dial":"strokes","values":[1.0000,2.0000,5.0000,10.0000,20.0000,50.0000,100.0000,"all"],"scored":0)"))
        << ending.out;
}

TEST_F(EvaluateCharts, TheStudyIsTheSameOnAnyNumberOfThreads) {
    const Words words{"-q", "--json", "--study", "needed"};
    Words one = words, four = words;
    one.insert(one.end(), {"--jobs", "1"});
    four.insert(four.end(), {"--jobs", "4"});
    const std::string alone = evaluate(one).out;
    EXPECT_TRUE(holds(alone, "\"recipe\":\"auto\",\"chosen\":\"")) << alone;
    EXPECT_EQ(alone, evaluate(four).out);
    const Ending text = evaluate({"-q", "--study", "needed", "-m", "embosser"});
    EXPECT_TRUE(holds(text.out, "30: ")) << text.out;
    EXPECT_FALSE(holds(text.out, "45: ")) << "an embosser shows no more: " << text.out;
}

}  // namespace
}  // namespace tactics
