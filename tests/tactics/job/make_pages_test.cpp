// SPDX-License-Identifier: Apache-2.0
// Pages through the library, as a program would ask for them that is no command line.
#include "tactics/job/make_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "filters/list.h"
#include "tests/cli/picture.h"
#include "tests/cli/tool.h"

namespace tactics::make_pages_test {
namespace {

class MakePages : public testing::Test {
protected:
    MakePages() {
        tests::write_bytes(folder / "disc.tif",
                           tests::grey_picture(120, 90, [](int x, int y) { return std::hypot(x - 60, y - 45) < 30 ? 20 : 220; }));
    }
    Job job(const std::string& page) const {
        return {{(folder / "disc.tif").string(), {output_to((folder / page).string())}}, {}};
    }

    tests::Folder folder;
};

TEST_F(MakePages, OfAJobAlone) {
    const Outcome outcome = make_pages(job("a.pdf"));
    EXPECT_EQ(outcome.error, "");
    EXPECT_FALSE(outcome.recipe.empty() || outcome.reason.empty()) << "chosen by the picture";
    ASSERT_EQ(outcome.made.size(), 1u);
    EXPECT_EQ(tests::bytes_of(folder / "a.pdf").size(), outcome.made[0].bytes);
    EXPECT_TRUE(tests::bytes_of(folder / "a.pdf").starts_with("%PDF"));
}

TEST_F(MakePages, TheStepsAreToldInTheirOrder) {
    std::vector<JobStep> steps;
    const Watch watch{.goes_on = [&](JobStep step) {
        steps.push_back(step);
        return true;
    }};
    EXPECT_EQ(make_pages(job("a.svg"), watch).error, "");
    EXPECT_EQ(steps, (std::vector{JobStep::reading, JobStep::drawing, JobStep::laying_out, JobStep::writing}));
}

TEST_F(MakePages, WhatIsGivenUpLeavesNothing) {
    for (const JobStep last : {JobStep::reading, JobStep::drawing, JobStep::laying_out, JobStep::writing}) {
        const Watch watch{.goes_on = [&](JobStep step) { return step != last; }};
        const Outcome outcome = make_pages(job("a.svg"), watch);
        EXPECT_TRUE(outcome.error.english().ends_with("disc.tif: given up; nothing was written")) << outcome.error.english();
        EXPECT_FALSE(std::filesystem::exists(folder / "a.svg"));
    }
}

TEST_F(MakePages, FaultsNeedNoCommandLine) {
    EXPECT_TRUE(make_pages({{(folder / "disc.tif").string(), {}}, {}})
                    .error.english()
                    .ends_with("no output is named, so nothing would be made"));
    EXPECT_TRUE(make_pages({{"missing.png", job("a.pdf").outputs}, {}}).error.english().starts_with("missing.png: "));
    EXPECT_THROW(output_to("page.xyz"), Error);
    Job alone = job("a.pdf");
    alone.wish.only = true;
    EXPECT_NE(make_pages(alone).error.english().find("no subject is named"), std::string::npos);
    Job with_subject = job("a.pdf");
    with_subject.chain.base = find_recipe("map", "recipe");
    with_subject.wish.subject = {{0.2, 0.2, 0.8, 0.8}};
    EXPECT_NE(make_pages(with_subject).error.english().find("recipe map has no filter outlines"), std::string::npos);
}

TEST_F(MakePages, ManyAtATimeAreAsOneAlone) {
    ASSERT_EQ(make_pages(job("alone.svg")).error, "");
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([this, i] { EXPECT_EQ(make_pages(job(std::to_string(i) + ".svg")).error, ""); });
    threads.clear();
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(tests::bytes_of(folder / (std::to_string(i) + ".svg")), tests::bytes_of(folder / "alone.svg"));
}

// The capitals of a table of eight dots have dot 7.
TEST_F(MakePages, BrailleThatLosesDotsIsToldOnce) {
    const auto notes_of = [&](const std::vector<std::string>& pages, const std::string& title, bool eight) {
        Job job{{(folder / "disc.tif").string(), {}}, {}};
        for (const std::string& page : pages) {
            const auto colon = page.find(':');
            const std::string path = (folder / page.substr(colon + 1)).string();
            job.outputs.push_back(colon == page.npos ? output_to(path) : Output{find_format(page.substr(0, colon)), path, ""});
        }
        job.sheet.title = title;
        job.sheet.braille_table = "en-us-comp8.ctb";
        if (eight)
            for (const std::string_view name : {"pef", "generic"}) {
                const Format* format = find_format(name);
                Settings settings(format->options);
                settings.set("dots", "8", "test", name);
                job.settings.emplace_back(format, settings);
            }
        const Outcome outcome = make_pages(job);
        EXPECT_EQ(outcome.error, "");
        std::string told;
        for (const std::string& note : texts_of(outcome.notes))
            if (note.find("dots 7 and 8") != std::string::npos) told += note.substr(0, note.find(';')) + "\n";
        return told;
    };
    EXPECT_EQ(notes_of({"a.brf"}, "A disc, not ABC", false),
              "4 cells of its braille lose dots 7 and 8, which brf does not have\n");
    EXPECT_EQ(notes_of({"a.brf", "a.pef", "generic:a.prn"}, "A disc", false),
              "1 cell of its braille loses dots 7 and 8, which brf, generic and pef do not have\n");
    EXPECT_EQ(notes_of({"a.brf"}, "a disc, not abc", false), "");
    EXPECT_EQ(notes_of({"a.pdf", "a.svg", "a.pef", "generic:a.prn", "index-v4:b.prn"}, "A disc", true), "");
}

#ifdef TACTICS_HELLO
TEST_F(MakePages, HelloIsAProgramOfTwentyLines) {
    const tests::Ending end = tests::run_tool(folder, {TACTICS_HELLO, "disc.tif", "disc.pdf"});
    EXPECT_EQ(end.code, 0) << end.err;
    ASSERT_EQ(make_pages(job("same.pdf")).error, "");
    EXPECT_EQ(tests::bytes_of(folder / "disc.pdf"), tests::bytes_of(folder / "same.pdf"));
    EXPECT_EQ(tests::run_tool(folder, {TACTICS_HELLO, "missing.png", "disc.pdf"}).code, 1);
    const std::string text = tests::bytes_of(TACTICS_SOURCE_DIR "/samples/hello.cpp");
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 20);
}
#endif

// Seen from above, a wedge twice as wide as deep is a rectangle of that shape.
TEST_F(MakePages, OfAModelAreItsTopView) {
    std::string model = "solid wedge\n";
    const auto corner = [&](int x, int y, int z) {
        model += "vertex " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    };
    const auto triangle = [&](std::array<std::array<int, 3>, 3> corners) {
        model += "facet\n";
        for (const auto& [x, y, z] : corners) corner(x, y, z);
        model += "endfacet\n";
    };
    triangle({{{0, 0, 3}, {4, 0, 3}, {4, 2, 3}}});
    triangle({{{0, 0, 3}, {4, 2, 3}, {0, 2, 3}}});
    triangle({{{0, 0, 0}, {4, 0, 0}, {4, 2, 3}}});
    tests::write_bytes(folder / "wedge.stl", model + "endsolid\n");
    const Job job{{(folder / "wedge.stl").string(), {{find_format("svg"), "", ""}}}, {}};
    const Outcome outcome = make_pages(job);
    ASSERT_EQ(outcome.error, "");
    EXPECT_EQ(outcome.picture.format, "STL model");
    const Page& page = outcome.layouts.front().shown.front();
    ASSERT_FALSE(page.strokes.empty() && page.areas.empty());
    double left = 1e9, right = 0, top = 1e9, bottom = 0;
    const auto take = [&](const Point& p) {
        left = std::min(left, p.x), right = std::max(right, p.x), top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    };
    for (const PageStroke& stroke : page.strokes) std::for_each(stroke.points.begin(), stroke.points.end(), take);
    for (const Area& area : page.areas)
        for (const auto& ring : area.rings) std::for_each(ring.begin(), ring.end(), take);
    EXPECT_NEAR((right - left) / (bottom - top), 2, 0.1);
}

}  // namespace
}  // namespace tactics::make_pages_test
