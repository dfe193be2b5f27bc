// SPDX-License-Identifier: Apache-2.0
// `tactics relief` as a person or a script would call it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cli/tool.h"
#include "tests/print/mesh.h"

namespace tactics::tests::relief_test {
namespace {

std::string pgm(int width, int height) {
    std::string text = "P5 " + std::to_string(width) + " " + std::to_string(height) + " 255\n";
    for (int i = 0; i < width * height; ++i) text += static_cast<char>(i % width * 255 / (width - 1));
    return text;
}

TEST(Relief, APictureBecomesAllFilesOfHeightsAndTheyComeBack) {
    const Folder folder;
    write_bytes(folder / "ramp.pgm", pgm(52, 20));
    const Ending made = run_tactics(folder, {"relief", "ramp.pgm", "--pitch", "0.5mm", "--high", "5mm", "-o", "a.png", "-o",
                                             "a.tif", "-o", "a.exr", "-o", "a.stl"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(
        made.err,
        "ramp.pgm: picture (PNM) of 52 x 20 samples 0.5 mm apart, 26 x 10 mm; heights 0 to 5 mm, black is 0 and white 5 mm\n");
    EXPECT_EQ(made.out, "");
    expect_solid(mesh_of(bytes_of(folder / "a.stl")));
    for (const char* name : {"a.png", "a.tif", "a.exr"}) {
        const Ending back = run_tactics(folder, {"relief", name, "-q", "-o", "b.png"});
        EXPECT_EQ(back.code, 0) << back.err;
        EXPECT_EQ(back.err, "");
        EXPECT_EQ(bytes_of(folder / "b.png"), bytes_of(folder / "a.png")) << name;
    }
    const Ending decimal = run_tactics(folder, {"relief", "a.png", "--samples", "decimal", "-o", "d.tiff", "--json"});
    EXPECT_EQ(decimal.out,
              "{\"schema\":1,\"input\":\"a.png\",\"format\":\"16-bit "
              "PNG\",\"columns\":52,\"rows\":20,\"pitch_mm\":0.5,\"width_mm\":26,\"height_mm\":10,\"low_mm\":0,\"high_mm\":5,"
              "\"lowest_mm\":0,\"highest_mm\":5,\"notes\":[],\"outputs\":[\"d.tiff\"]}\n");
    EXPECT_EQ(decimal.err, "");
}

TEST(Relief, AModelIsSeenFromAbove) {
    const Folder folder;
    write_bytes(folder / "ramp.pgm", pgm(40, 20));
    ASSERT_EQ(run_tactics(folder, {"relief", "ramp.pgm", "--pitch", "0.5mm", "--low", "1mm", "--high", "5mm", "--base", "1mm",
                                   "-o", "a.stl"})
                  .code,
              0);
    // As thick as its plate and its heights: the same map again, but for the plate.
    const Ending seen = run_tactics(folder, {"relief", "a.stl", "--pitch", "0.5mm", "-o", "b.png"});
    EXPECT_EQ(seen.code, 0);
    EXPECT_EQ(seen.err,
              "a.stl: a model has no unit: its numbers are taken as mm, so it is 20 mm wide; change with --width\n"
              "a.stl: STL model of 40 x 20 samples 0.5 mm apart, 20 x 10 mm; heights 1 to 5 mm, black is 0 and white 5 mm\n");
    EXPECT_TRUE(holds(run_tactics(folder, {"relief", "-", "--pitch", "0.5mm", "-o", "b.png"}, bytes_of(folder / "a.stl")).err,
                      "standard input: STL model of 40 x 20"));
}

TEST(Relief, AWorldHasItsSizeAndSaysWhatIsLeftOut) {
    const Folder folder;
    write_bytes(folder / "cube.wrl",
                "#VRML V2.0 utf8\nShape { geometry Box { size 0.02 0.005 0.01 } }\nInline { url \"lamp.wrl\" }\n");
    const Ending seen = run_tactics(folder, {"relief", "cube.wrl", "--pitch", "0.5mm", "-o", "b.png"});
    EXPECT_EQ(seen.code, 0);
    EXPECT_EQ(
        seen.err,
        "cube.wrl: left out: Inline of \"lamp.wrl\": no other file is read; take it by itself (line 3)\n"
        "cube.wrl: it is 20 mm wide; change with --width\n"
        "cube.wrl: VRML97 model of 40 x 20 samples 0.5 mm apart, 20 x 10 mm; heights 5 to 5 mm, black is 0 and white 5 mm\n");
}

// Whole phrases, with the numbers as the language writes them; what programs read stays as it is.
TEST(Relief, SaysItInTheUsersLanguage) {
    const Folder folder;
    write_bytes(folder / "ramp.pgm", pgm(4, 4));
    write_bytes(folder / "s.svg",
                "<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='20mm'><path d='M2 9H40' "
                "fill='none' stroke='#000'/></svg>");
    const auto run = [&](const std::string& locale, const Words& words) {
        Words all{"env", "-u", "LANGUAGE", "LC_ALL=" + locale, TACTICS_PROGRAM};
        all.insert(all.end(), words.begin(), words.end());
        const Ending ending = run_tool(folder, all);
        return ending.out + ending.err;
    };
    const std::string german = run("de_DE.UTF-8", {"relief", "ramp.pgm", "-o", "a.png"});
    EXPECT_TRUE(holds(german, "ramp.pgm: Bild (PNM) mit 4 x 4 ")) << german;
    EXPECT_TRUE(holds(german, "0,264583 mm, ")) << german;
    EXPECT_TRUE(holds(german, " 1,058 x 1,058 mm")) << german;
    EXPECT_FALSE(holds(german, "0.264583")) << german;
    const std::string french = run("fr_FR.UTF-8", {"relief", "ramp.pgm", "-o", "a.png"});
    EXPECT_TRUE(holds(french, "image (PNM)")) << french;
    const std::string json = run("de_DE.UTF-8", {"relief", "ramp.pgm", "-o", "a.png", "--json", "--quiet"});
    EXPECT_TRUE(holds(json, "\"PNM picture\"")) << json;
    EXPECT_FALSE(holds(json, "0,264583")) << json;
    const std::string measured = run("de_DE.UTF-8", {"measure", "s.svg"});
    EXPECT_TRUE(holds(measured, "s.svg: Zeichnung mit ")) << measured;
    EXPECT_FALSE(holds(run("de_DE.UTF-8", {"play", "ramp.pgm", "--device", "nothing"}), " or ")) << "of the devices' examples";
}

TEST(Relief, SaysWhatItTookAndWhatIsWrong) {
    const Folder folder;
    write_bytes(folder / "ramp.pgm", pgm(4, 4));
    EXPECT_EQ(run_tactics(folder, {"relief", "ramp.pgm", "-o", "a.png"}).err,
              "ramp.pgm: it tells no pitch: 0.264583 mm, a pixel of a screen, is taken; say what it is with --pitch or --width\n"
              "ramp.pgm: it tells no heights: black is 0 mm and white 10 mm; say what they are with --low and --high\n"
              "ramp.pgm: picture (PNM) of 4 x 4 samples 0.264583 mm apart, 1.058 x 1.058 mm; heights 0 to 10 mm, black is 0 and "
              "white 10 mm\n");
    write_bytes(folder / "broken.stl", "solid or not");
    const std::vector<std::pair<Words, std::string>> wrong = {
        {{"relief", "-o", "a.png"}, "relief: name one picture"},
        {{"relief", "ramp.pgm"}, "relief: say where to write it: -o relief.png"},
        {{"relief", "ramp.pgm", "-o", "a.jpg"}, "--output: \"a.jpg\" must end in .png, .tif, .exr, .felt or .stl"},
        {{"relief", "ramp.pgm", "-o", "a.png", "-o", "./a.png"}, "--output: ./a.png is named twice"},
        {{"relief", "a.png", "-o", "a.png"}, "--output: a.png is the input"},
        {{"relief", "ramp.pgm", "-o", "a.png", "--pitch", "0"},
         "--pitch: it cannot be \"0\"; it is a length such as 12mm or 0.5in, over 0"},
        {{"relief", "ramp.pgm", "-o", "a.png", "--low", "x"}, "--low: it cannot be \"x\""},
        {{"relief", "ramp.pgm", "-o", "a.png", "--base", "3mm"}, "--base: only an .stl has a plate"},
        {{"relief", "ramp.pgm", "-o", "a.stl", "--base", "0.01mm"},
         "--base: stl base=0.01mm is out of range; it is 0.2 to 100 mm"},
        {{"relief", "ramp.pgm", "-o", "a.png", "--samples", "decimal"}, "--samples: only a .tif can hold either"},
        {{"relief", "ramp.pgm", "-o", "a.tif", "--samples", "12"},
         "--samples: heightmap-tiff samples cannot be \"12\"; it is one of 16, decimal"},
        {{"relief", "ramp.pgm", "-o", "a.png", "--low", "5", "--high", "2"},
         "--high: the highest place, 2 mm, is not over the lowest, 5 mm"},
    };
    for (const auto& [words, part] : wrong) {
        const Ending ending = run_tactics(folder, words);
        EXPECT_EQ(ending.code, 1) << part;
        EXPECT_TRUE(holds(ending.err, part)) << ending.err;
    }
    const Ending broken = run_tactics(folder, {"relief", "broken.stl", "-o", "c.png"});
    EXPECT_EQ(broken.code, 2);
    EXPECT_TRUE(holds(broken.err, "broken.stl:1: the file ends before \"endsolid\"")) << broken.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "c.png"));
}

// Grid below axes below data, from the table to the map.
TEST(Relief, AChartHasLowAxesAndHighCurves) {
    const Folder folder;
    write_bytes(folder / "table.csv", "t,F\n0,1\n1,3\n2,2\n");
    const Ending made = run_tactics(folder, {"chart", "table.csv", "-o", "chart.height.png", "-o", "chart.height.tif", "-o",
                                             "chart.svg", "-s", "heightmap.height=1mm", "-s", "heightmap.axes=50"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(holds(bytes_of(folder / "chart.svg"), "class=\"tactics-axis\""));
    const Ending low = run_tactics(folder, {"relief", "chart.height.png", "--json", "-o", "chart.exr"});
    EXPECT_TRUE(holds(low.out, "\"pitch_mm\":0.1,")) << low.out << low.err;
    EXPECT_TRUE(holds(low.out, "\"high_mm\":1,\"lowest_mm\":0,\"highest_mm\":1,")) << low.out;
}

// A plane that rises to the right, as rows of x, y and z in any order, and as rows of heights.
TEST(Relief, ATableOfHeightsBecomesItsSurface) {
    const Folder folder;
    std::string points = "north (km),east (km),height (m)\n", rows;
    for (int j = 0; j < 5; ++j) {
        for (int i = 6; i >= 0; --i)
            points += std::to_string(j * 3) + "," + std::to_string(i * 3) + "," + std::to_string(100 + 20 * i) + "\n";
        for (int i = 0; i < 7; ++i) rows += (i > 0 ? "," : "") + std::to_string(100 + 20 * i);
        rows += "\n";
    }
    write_bytes(folder / "points.csv", points);
    write_bytes(folder / "rows.csv", rows);
    const Ending made = run_tactics(folder, {"relief", "points.csv", "--x", "east", "--y", "north", "--z", "height", "--width",
                                             "60mm", "--low", "1mm", "--high", "5mm", "--json", "-o", "a.tif"});
    ASSERT_EQ(made.code, 0) << made.err;
    // 18 km wide and 12 km deep; a plane is lowest and highest a quarter of a millimetre before its sides.
    for (const char* told : {"\"width_mm\":60", "\"height_mm\":40", "\"lowest_mm\":1.01", "\"highest_mm\":4.98"})
        EXPECT_TRUE(holds(made.out, told)) << made.out;
    ASSERT_EQ(run_tactics(folder, {"relief", "rows.csv", "--matrix", "--width", "60mm", "--low", "1mm", "--high", "5mm", "-q",
                                   "-o", "b.tif"})
                  .code,
              0);
    EXPECT_EQ(bytes_of(folder / "a.tif"), bytes_of(folder / "b.tif"));
}

TEST(Relief, ATableWithoutHeightsIsRefusedWithTheWayOut) {
    const Folder folder;
    write_bytes(folder / "curve.csv", "time,speed\n0,1\n1,2\n2,1\n3,5\n");
    write_bytes(folder / "ramp.pgm", pgm(52, 20));
    const Ending curve = run_tactics(folder, {"relief", "curve.csv", "-o", "a.png"});
    EXPECT_EQ(curve.code, 2);
    EXPECT_TRUE(holds(curve.err, "no heights over a grid of x and y; name the column of heights with --z")) << curve.err;
    const Ending picture = run_tactics(folder, {"relief", "ramp.pgm", "--z", "height", "-o", "a.png"});
    EXPECT_EQ(picture.code, 1);
    EXPECT_TRUE(holds(picture.err, "--z: it is about a table")) << picture.err;
}

// Hills on a ground that is nearly flat, which a few levels lose.
std::string hills() {
    std::string text = "P5 200 120 255\n";
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 200; ++x) {
            const double hill = 190 * std::exp(-(std::pow(x - 60, 2) + std::pow(y - 50, 2)) / 300);
            text += static_cast<char>(static_cast<int>(hill) + x * y % 23);
        }
    return text;
}

TEST(Relief, ForAMediumItsHeightsAreThoseOfWhichThatLosesLeast) {
    const Folder folder;
    write_bytes(folder / "hills.pgm", hills());
    const Ending made =
        run_tactics(folder, {"relief", "hills.pgm", "--width", "100mm", "--high", "10mm", "--for", "graphiti", "-o", "pins.png"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(holds(made.err, "hills.pgm: for graphiti: least loss ")) << made.err;
    EXPECT_TRUE(holds(made.err, " instead of ")) << made.err;
    EXPECT_TRUE(holds(made.err, ", 100 x 60 mm; heights ")) << made.err;  // as wide as it was
    // Measures the written file: the medium carries more of it than of the source.
    const auto carried = [&](const std::string& file, const Words& more) {
        Words words{"measure", file, "--media", "graphiti", "--json"};
        words.insert(words.end(), more.begin(), more.end());
        const std::string told = run_tactics(folder, words).out;
        return std::stod(told.substr(told.find("\"carried_bits\":") + 15));
    };
    EXPECT_GT(carried("pins.png", {}), carried("hills.pgm", {"--width", "100mm", "--high", "10mm"}));
    const Ending wrong = run_tactics(folder, {"relief", "hills.pgm", "--for", "grafiti", "-o", "x.png"});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_TRUE(holds(wrong.err, "--for: there is no medium \"grafiti\" (graphiti?)")) << wrong.err;
}

}  // namespace
}  // namespace tactics::tests::relief_test
