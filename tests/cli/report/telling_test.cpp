// SPDX-License-Identifier: Apache-2.0
// What `tactics convert` tells of what it did and of what it could not do.
#include "tests/cli/converting.h"

namespace tactics::telling_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

class Telling : public Convert {};

TEST_F(Telling, TheNearestFileIsNamed) {
    fs::create_directory(folder / "dicz.tif");  // as near, but a folder
    EXPECT_EQ(convert({"dics.tif", "-o", "a.svg"}).err, "tactics: dics.tif: there is no such file (disc.tif?)\n");
    EXPECT_EQ(convert({"./disc.tiff", "-o", "a.svg"}).err, "tactics: ./disc.tiff: there is no such file (disc.tif?)\n");
    EXPECT_EQ(convert({"other.png", "-o", "a.svg"}).err,
              "tactics: other.png: there is no such file; see what is there with: ls .\n");
    EXPECT_EQ(convert({"no/disc.tif", "-o", "a.svg"}).err,
              "tactics: no/disc.tif: there is no folder no; check how it is spelled\n");
    write_bytes(folder / "own.recipe", "threshold\n");
    EXPECT_EQ(convert({"disc.tif", "-r", "on.recipe", "-o", "a.svg"}).err,
              "tactics: on.recipe: there is no such file (own.recipe?)\n");
}

TEST_F(Telling, NoFolderStaysBehindForNothing) {
    fs::create_directories(folder / "there/empty");
    write_bytes(folder / "bad.tif", "no picture\n");
    for (const std::string out : {"new/", "there/new/deep/", "there/empty/", "./x/../y/"})
        EXPECT_EQ(convert({"bad.tif", "missing.tif", "-q", "-o", out}).code, 2) << out;
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "new/", "-o", "disc.tif/new/"}).code, 2);
    EXPECT_EQ(names(), "bad.tif disc.tif there");
    EXPECT_EQ(names("there"), "empty");
    EXPECT_EQ(convert({"bad.tif", "disc.tif", "-q", "-o", "new/deep/", "-t", "svg"}).code, 2);
    EXPECT_EQ(names("new/deep"), "disc.svg");
}

TEST_F(Telling, AnEmptyPageIsToldAndIsNoFailure) {
    write_bytes(folder / "dot.tif", grey_picture(1, 1, [](int, int) { return 128; }));
    const Ending one = convert({"dot.tif", "-r", "photo", "-o", "dot.svg", "-o", "dot.brf"});
    EXPECT_EQ(one.code, 0);
    EXPECT_TRUE(
        one.err.ends_with("\ndot.tif: nothing was drawn: recipe photo leaves nothing to feel on dot.svg, dot.brf; try "
                          "--detail contours or another --recipe\n"))
        << one.err;
    EXPECT_TRUE(fs::exists(folder / "dot.svg"));
    // A picture of dots that has none.
    const Ending json = convert({"dot.tif", "disc.tif", "-r", "line-art", "-o", "out/", "--json"});
    EXPECT_EQ(json.code, 0);
    EXPECT_TRUE(json.err.starts_with(
        "dot.tif: nothing was drawn: recipe line-art leaves nothing to feel on out/dot.pdf; try another --recipe\n2 of 2 "))
        << json.err;
    EXPECT_TRUE(holds(json.out, "\"empty\":true,") && holds(json.out, "\"empty\":false,")) << json.out;
    write_bytes(folder / "white.tif", grey_picture(20, 20, [](int, int) { return 255; }));
    write_bytes(folder / "none.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\"/>");
    EXPECT_TRUE(holds(convert({"none.svg", "-o", "none.pdf"}).err,
                      "none.svg: nothing was drawn: it has no lines that could be felt on none.pdf; look"));
    EXPECT_TRUE(holds(convert({"white.tif", "-f", "threshold", "-o", "white.svg"}).err, "white.tif: nothing was drawn: "));
    const Ending drawn = convert({"disc.tif", "-f", "threshold", "-o", "disc.svg"});
    EXPECT_TRUE(holds(drawn.err, "a picture of dots") && !holds(drawn.err, "nothing was drawn")) << drawn.err;
    EXPECT_EQ(convert({"dot.tif", "-r", "photo", "-o", "dot.svg", "--quiet"}).err, "");
}

// What a filter chose from the picture is told, with the word that changes it; what is given is not chosen.
TEST_F(Telling, WhatWasChosenIsToldAndCanBeSet) {
    const Ending chosen = convert({"disc.tif", "-r", "regions", "-o", "disc.svg"});
    EXPECT_EQ(chosen.code, 0);
    EXPECT_TRUE(holds(chosen.err, "disc.tif: kmeans k=2: 2 colours explain ") &&
                holds(chosen.err, "; change with --set kmeans.k=NUMBER\n"))
        << chosen.err;
    EXPECT_TRUE(holds(chosen.err,
                      "disc.tif: regions smallest=18mm: less wide regions have no room for a texture; change with --set "
                      "regions.smallest=NUMBER\n"))
        << chosen.err;
    EXPECT_TRUE(holds(chosen.err, "1 line of ") && holds(chosen.err, ", 1 textured area;")) << chosen.err;
    const Ending set =
        convert({"disc.tif", "-r", "regions", "-s", "kmeans.k=3", "-s", "regions.smallest=30mm", "-o", "disc.svg"});
    EXPECT_EQ(lines_in(set.err), 1u) << set.err;
    const Ending json = convert({"disc.tif", "-r", "regions", "-o", "disc.svg", "-o", "disc.brf", "--json"});
    EXPECT_TRUE(holds(json.out, "\"kmeans k=2 colour=yes\"") && holds(json.out, "\"chosen\":[\"kmeans k=2: ") &&
                holds(json.out, "\"textured_areas\":1"))
        << json.out;
}

// What was really used: no embosser shows 150 dpi. What is saved stays the recipe that was asked for.
TEST_F(Telling, StepsAreThoseOfTheFirstPage) {
    const auto steps = [&](Words words) {
        words.insert(words.begin(), {"disc.tif", "--json", "-f", "resample dpi=90", "-f", "threshold"});
        const std::string out = convert(words).out;
        const auto from = std::min(out.find("\"steps\":"), out.size());
        return out.substr(from, out.find(']', from) - from + 1);
    };
    EXPECT_EQ(steps({"-o", "a.svg", "-o", "a.brf"}), "\"steps\":[\"resample dpi=90\",\"threshold\"]");
    EXPECT_EQ(steps({"-o", "a.brf", "-o", "a.svg", "--save-recipe", "own.recipe"}),
              "\"steps\":[\"resample dpi=30\",\"threshold\"]");
    EXPECT_EQ(bytes_of(folder / "own.recipe"), "resample dpi=90\nthreshold\n");
}

// A part is drawn as well as the picture of that part alone: as finely, and with the same lengths on the page.
TEST_F(Telling, ACroppedPartIsThePictureOfThatPart) {
    const auto waves = [](int x, int y) {
        return 128 + std::lround(60 * std::sin(x * 0.021) * std::cos(y * 0.017) + 60 * std::sin(x * y * 0.00009));
    };
    write_bytes(folder / "whole.tif", grey_picture(1600, 1280, waves));
    write_bytes(folder / "part.tif", grey_picture(800, 320, [&](int x, int y) { return waves(x + 800, y + 640); }));
    const Words crop{"-f", "crop left=50 top=50 bottom=25"};
    const Words rest{"-q",
                     "-f",
                     "resample dpi=100",
                     "-f",
                     "sobel blur=1mm",
                     "-f",
                     "threshold method=fixed level=20",
                     "-f",
                     "trace shortest=4mm",
                     "-f",
                     "simplify",
                     "--width",
                     "127mm"};
    const auto page = [&](const std::string& picture, Words words) {
        words.insert(words.begin(), {picture, "-o", "page.svg"});
        words.insert(words.end(), rest.begin(), rest.end());
        const Ending ending = convert(words);
        EXPECT_EQ(ending.code, 0) << ending.err;
        return bytes_of(folder / "page.svg");
    };
    const std::string part = page("part.tif", {});
    EXPECT_GT(part.size(), 3000u);
    EXPECT_TRUE(page("whole.tif", crop) == part);
}

}  // namespace
}  // namespace tactics::telling_test
