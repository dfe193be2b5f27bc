// SPDX-License-Identifier: Apache-2.0
// `tactics measure` as a person or a script would call it.
#include <gtest/gtest.h>

#include "tests/cli/tool.h"

namespace tactics::tests::measure_test {
namespace {

std::string hills(int width, int height) {
    std::string text = "P5 " + std::to_string(width) + " " + std::to_string(height) + " 255\n";
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) text += static_cast<char>((x * x / 40 + x * y / 30 + (x * 7 + y * 13) % 5) % 256);
    return text;
}

TEST(Measure, TellsBitsAsAnIntervalAndMediaAsATable) {
    const Folder folder;
    write_bytes(folder / "hills.pgm", hills(240, 160));
    const Ending told = run_tactics(folder, {"measure", "hills.pgm", "--media", "swell,graphiti,omni,desktop"});
    ASSERT_EQ(told.code, 0) << told.err;
    EXPECT_TRUE(holds(told.out, "hills.pgm: PNM of 240 x 160 cells, 63.5 x 42.333 mm, 256 levels from 0 to 10 mm\n")) << told.out;
    EXPECT_TRUE(holds(told.out, "bits in it: "));
    EXPECT_TRUE(holds(told.out, "topology index 0."));
    EXPECT_TRUE(holds(told.out, "what is smaller than 2.5 mm there"));
    EXPECT_TRUE(holds(told.out, "heights between its 5 levels (2 mm apart)"));
    EXPECT_TRUE(holds(told.out, "nothing\n"));  // desktop
    EXPECT_TRUE(holds(told.err, "its lightness is taken for heights from 0 to 10 mm; say others with --low and --high"))
        << told.err;
    const Ending json = run_tactics(folder, {"measure", "-", "--media", "all", "--best", "--levels-of-detail", "--json"},
                                    bytes_of(folder / "hills.pgm"));
    EXPECT_EQ(json.code, 0) << json.err;
    EXPECT_TRUE(holds(json.out, "\"input\":\"standard input\",\"format\":\"PNM\",\"columns\":240"));
    EXPECT_TRUE(holds(json.out, "{\"medium\":\"index-v4\",\"kind\":\"embosser\""));
    EXPECT_TRUE(holds(json.out, "\"force_levels\":"));
    EXPECT_TRUE(holds(json.out, "\"levels_of_detail\":[{\"columns\":240,\"rows\":160,"));
    EXPECT_EQ(json.err, "");
    EXPECT_EQ(run_tactics(folder, {"measure", "hills.pgm", "--media", "all", "--json"}).out,
              run_tactics(folder, {"measure", "hills.pgm", "--media", "all", "--json"}).out);
}

TEST(Measure, TakesWhateverTheProductReads) {
    const Folder folder;
    write_bytes(folder / "plan.svg",
                "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='80mm' viewBox='0 0 100 80'>"
                "<path d='M5 5 H90 V70 H5 Z M20 20 H80 M20 21 H80' fill='none' stroke='black'/></svg>");
    write_bytes(folder / "curve.csv", "time (s),force (N)\n0,0\n1,2\n2,1\n3,4\n");
    write_bytes(folder / "heights.csv", "0,1,2,3\n1,5,2,3\n0,1,9,3\n");
    write_bytes(folder / "hills.pgm", hills(240, 160));
    const Ending plan = run_tactics(folder, {"measure", "plan.svg", "--media", "swell,index-v4"});
    ASSERT_EQ(plan.code, 0) << plan.err;
    EXPECT_TRUE(holds(plan.out, "plan.svg: drawing of ")) << plan.out;
    EXPECT_TRUE(holds(plan.out, "lines closer than ")) << plan.out;
    for (const Words& words : {Words{"measure", "curve.csv"}, Words{"measure", "heights.csv", "--matrix"},
                               Words{"measure", "hills.pgm", "--recipe", "line-art"}}) {
        const Ending told = run_tactics(folder, words);
        EXPECT_EQ(told.code, 0) << words[1] << told.err;
        EXPECT_TRUE(holds(told.out, "bits in it: ")) << told.out;
    }
    ASSERT_EQ(run_tactics(folder, {"relief", "hills.pgm", "--pitch", "0.5mm", "--high", "5mm", "-o", "hills.png"}).code, 0);
    const Ending relief = run_tactics(folder, {"measure", "hills.png", "--media", "omni"});
    EXPECT_TRUE(holds(relief.out, "65536 levels from 0 to 5 mm")) << relief.out << relief.err;
    EXPECT_EQ(relief.err, "");
}

TEST(Measure, VoxelsOfFiveEachWayAreAThousandBits) {
    const Folder folder;
    std::string bytes = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 5 5 5\nencoding: raw\n\n";
    for (int i = 0; i < 125; ++i) bytes += static_cast<char>(i * i * 7 % 256);
    write_bytes(folder / "voxels.nrrd", bytes);
    const Ending told = run_tactics(folder, {"measure", "voxels.nrrd", "--levels-of-detail"});
    ASSERT_EQ(told.code, 0) << told.err;
    EXPECT_TRUE(holds(told.out, "voxels.nrrd: NRRD of 5 x 5 x 5 voxels, 256 levels\n")) << told.out;
    EXPECT_TRUE(holds(told.out, "; 1000 as it is written\n")) << told.out;
    EXPECT_TRUE(holds(told.out, "3 x 3 x 3")) << told.out;
    EXPECT_TRUE(holds(run_tactics(folder, {"measure", "-", "--json"}, bytes).out, "\"raw_bits\":1000,"));
    const Ending forces = run_tactics(folder, {"measure", "-"},
                                      "NRRD0004\ntype: float\ndimension: 4\nsizes: 3 2 1 1\nencoding: ascii\n\n0 0 1 0 0 -2\n");
    EXPECT_TRUE(holds(forces.out, "NRRD of 2 x 1 x 1 voxels with three components each, 65535 levels")) << forces.out;
    EXPECT_TRUE(holds(forces.err, "its numbers are counted in 65535 levels from -2 to 2")) << forces.err;
    const Ending media = run_tactics(folder, {"measure", "voxels.nrrd", "--media", "omni"});
    EXPECT_EQ(media.code, 1);
    EXPECT_TRUE(holds(media.err, "--media: it is about heights and drawings, and voxels.nrrd is voxels")) << media.err;
    EXPECT_EQ(run_tactics(folder, {"measure", "-"}, bytes.substr(0, 100)).code, 2);
}

TEST(Measure, SaysWhatIsWrong) {
    const Folder folder;
    write_bytes(folder / "flat.pgm", "P5 3 2 255\n" + std::string(6, 'a'));
    write_bytes(folder / "dot.pgm", "P5 1 1 255\na");
    write_bytes(folder / "hills.pgm", hills(24, 16));
    write_bytes(folder / "empty.png", "");
    const auto expect = [&](const Words& words, int code, std::string_view part) {
        const Ending ending = run_tactics(folder, words);
        EXPECT_EQ(ending.code, code) << ending.err;
        EXPECT_TRUE(holds(ending.err, part)) << ending.err;
        EXPECT_EQ(ending.out, "");
    };
    expect({"measure"}, 1, "measure: name one file");
    expect({"measure", "flat.pgm", "-q"}, 2,
           "tactics: flat.pgm: all of it has one height, so there is nothing to be felt or lost");
    expect({"measure", "dot.pgm", "-q"}, 2, "dot.pgm: all of it has one height");
    expect({"measure", "empty.png"}, 2, "empty.png: ");
    expect({"measure", "hills.pgm", "--media", "grafiti"}, 1, "--media: there is no medium \"grafiti\" (graphiti?)");
    expect({"measure", "hills.pgm", "--best"}, 1, "--best: it is about media; name some with --media");
    expect({"measure", "hills.pgm", "--low", "5mm", "--high", "5mm"}, 1, "--high: white must be higher than black");
    expect({"measure", "hills.pgm", "--width", "-1mm"}, 1, "--width");
}

TEST(Measure, ARecordingIsItsForces) {
    const Folder folder;
    std::string ticks = "time_s,x_mm,y_mm,finger_mm,force_n\n";
    for (int i = 0; i < 500; ++i) {
        ticks += std::to_string(i / 1000.0) + "," + std::to_string(i % 50) + ",0,1,";
        ticks += std::to_string(i * i % 97 / 10.0) + "\n";
    }
    write_bytes(folder / "ticks.csv", ticks);
    ASSERT_EQ(run_tactics(folder, {"encode", "ticks.csv", "-o", "ticks.felt", "-q"}).code, 0);
    const Ending table = run_tactics(folder, {"measure", "ticks.csv", "--media", "all"}),
                 packed = run_tactics(folder, {"measure", "ticks.felt", "--media", "all"});
    ASSERT_EQ(table.code, 0) << table.err;
    EXPECT_TRUE(holds(table.out, "ticks.csv: recording of 500 ticks in 0.499 s, forces up to 9.6 N in ")) << table.out;
    EXPECT_TRUE(holds(table.out, "forces over 3.3 N (")) << table.out;
    EXPECT_EQ(table.out.substr(table.out.find('\n')), packed.out.substr(packed.out.find('\n')));
    EXPECT_TRUE(holds(run_tactics(folder, {"measure", "ticks.csv", "--media", "swell"}).err,
                      "--media: a recording is of forces, which only mouse, omni, desktop and phantom have"));
    EXPECT_TRUE(
        holds(run_tactics(folder, {"measure", "ticks.felt", "--media", "omni", "--best"}).err, "--best: it is about heights"));
    // Its chart is a drawing, if that is asked for.
    EXPECT_TRUE(holds(run_tactics(folder, {"measure", "ticks.csv", "--recipe", "line-art"}).out, "drawing of"));
}

}  // namespace
}  // namespace tactics::tests::measure_test
