// SPDX-License-Identifier: Apache-2.0
// What programs may count on that read --json: the files in cli/schemas/ beside real answers, good ones and bad ones.
#include "tests/cli/schemas.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "cli/command.h"
#include "tests/cli/picture.h"

namespace tactics::schemas_test {
namespace {

using namespace tests;

std::set<std::string> commands_with_schemas() {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(TACTICS_SOURCE_DIR "/cli/schemas")) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(name.ends_with(".schema.json")) << name;
        names.insert(name.substr(0, name.find('.')));
    }
    return names;
}

class Schemas : public testing::Test {
protected:
    void SetUp() override {
        if (!has_json_schema()) GTEST_SKIP() << "python3-jsonschema is not installed";
        write_bytes(folder / "disc.tif", disc_picture());
        write_bytes(folder / "box.wrl",
                    "#VRML V2.0 utf8\nDEF Table Transform { children [ DEF Top Shape { geometry Box { size 2 1 1 } }\n"
                    "DEF Pin Transform { translation 4 0 0 children Shape { geometry Sphere { radius 0.001 } } } ] }\n");
        std::string lines = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100' width='100mm' height='100mm'>";
        for (int y = 40; y < 60; ++y)
            lines += "<path fill='none' stroke='black' stroke-width='0.5' d='M10 " + std::to_string(y) + "H90'/>";
        write_bytes(folder / "close.svg", lines + "</svg>");
        write_bytes(folder / "words.txt", "A first paragraph.\n\nAnd another.\n");
    }

    // Runs it, and compares what it answers.
    void expect(int code, Words words) const {
        const std::string command = words[0];
        words.push_back("--json");
        const Ending end = run_tactics(folder, words);
        EXPECT_EQ(end.code, code) << command << ": " << end.err;
        EXPECT_TRUE(end.out.starts_with("{\"schema\":1,") || (command == "devices" && end.out.empty()))
            << command << ": " << end.out;
        EXPECT_EQ(schema_faults(command, end.out), "") << command << ": " << end.out.substr(0, 2000);
    }

    const Folder folder;
};

TEST_F(Schemas, OfPages) {
    expect(0, {"convert", "disc.tif", "-o", "disc.pdf", "-o", "disc.svg", "-o", "disc.brf", "--label", "10%,10%=sky"});
    expect(0, {"convert", "disc.tif", "-o", "disc.pdf", "-u"});
    expect(0, {"convert", "disc.tif", "-o", "disc.pdf", "-u"});
    write_bytes(folder / "rain.csv", "month,rain,error\nMay,3,1\nJune,4,\n");
    expect(0, {"chart", "rain.csv", "-o", "rain.pdf", "--bars", "grouped", "--error", "error"});
    write_bytes(folder / "way.csv", "x,y\n1,2\n2,\n3,5\n");
    expect(0, {"chart", "way.csv", "-o", "way.pdf"});
    expect(0, {"chart", "way.csv", "--points", "-o", "way.pdf"});
    expect(0, {"defaults"});
    expect(0, {"convert", "rain.csv", "way.csv", "-o", "both.pdf"});
    expect(0, {"convert", "way.csv", "-o", "viewplus:way.png"});
    expect(0, {"convert", "disc.tif", "-r", "photo", "-o", "photo.pdf"});
    expect(0, {"convert", "box.wrl", "-o", "box.svg"});
    expect(0, {"convert", "words.txt", "--text", "-o", "words.brf"});
    expect(3, {"convert", "close.svg", "--as-drawn", "--strict", "-o", "as-drawn.svg"});
    expect(0, {"convert", "close.svg", "-o", "mended.svg"});
    expect(0, {"convert", "disc.tif", "-r", "photo", "--detail", "best", "-o", "best.svg"});
    expect(2, {"convert", "disc.tif", "missing.png", "-o", "pages/"});
    expect(0, {"check", "close.svg", "disc.svg"});
    expect(2, {"check", "missing.svg"});
    expect(0, {"describe", "disc.tif", "--title", "A disc"});
    expect(0, {"describe", "box.wrl"});
    expect(2, {"describe", "missing.png"});
}

TEST_F(Schemas, OfWhatIsThere) {
    expect(0, {"list"});
    expect(0, {"devices"});
}

TEST_F(Schemas, OfHeights) {
    expect(0, {"measure", "disc.tif", "--media", "swell,heightmap,index-v4,dot-pad,mouse,omni", "--best", "--levels-of-detail"});
    expect(0, {"relief", "disc.tif", "--high", "4mm", "-o", "disc.height.png"});
    expect(0, {"encode", "disc.height.png", "-o", "disc.felt"});
    expect(0, {"decode", "disc.felt"});
    std::string table = "x,y,z\n";
    for (int i = 0; i < 64; ++i)
        table += std::to_string(i % 8) + "," + std::to_string(i / 8) + "," + std::to_string(i % 3) + "\n";
    write_bytes(folder / "surface.csv", table);
    const Ending felt =
        run_tactics(folder, {"play", "surface.csv", "--z", "z", "--device", "arm", "--seconds", "2", "--csv", "ticks.csv", "-q"});
    ASSERT_EQ(felt.code, 0) << felt.err;
    expect(0, {"encode", "ticks.csv", "-o", "ticks.felt", "--deadband", "10%", "--device", "omni"});
    expect(0, {"decode", "ticks.felt", "-o", "back.csv"});
    expect(0, {"measure", "ticks.felt", "--media", "omni,mouse"});
    write_bytes(folder / "voxels.nrrd",
                "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n0 9 8 7 6 5 4 3\n");
    expect(0, {"measure", "voxels.nrrd", "--levels-of-detail"});
}

TEST_F(Schemas, OfMachines) {
    ASSERT_EQ(run_tactics(folder, {"convert", "disc.tif", "-o", "index-v4:disc.prn", "-q"}).code, 0);
    expect(0, {"preview", "disc.prn", "--embosser", "index-v4"});
    expect(0, {"emboss", "disc.prn", "--to", "sent.prn"});
    std::filesystem::create_directory(folder / "drawings");
    ASSERT_EQ(run_tactics(folder, {"convert", "disc.tif", "-o", "drawings/disc.svg", "-q"}).code, 0);
    expect(0, {"similar", "close.svg", "drawings"});
}

TEST_F(Schemas, AreStrictEnoughToFail) {
    const std::string good = R"({"schema":1,"address":"usb:","id":"","embosser":"","note":""})";
    EXPECT_EQ(schema_faults("devices", good + "\n"), "");
    for (const std::string bad : {R"({"schema":2,"address":"usb:","id":"","embosser":"","note":""})",
                                  R"({"schema":1,"address":"usb:","id":"","embosser":""})",
                                  R"({"schema":1,"address":"usb:","id":"","embosser":"","note":"","more":1})",
                                  R"({"schema":1,"address":7,"id":"","embosser":"","note":""})", "[NaN]"})
        EXPECT_NE(schema_faults("devices", bad + "\n"), "") << bad;
}

// show is compared where its display is, in show_test.cpp.
TEST(SchemaFiles, AreNamedByHelpAndThereForEachCommand) {
    const std::set<std::string> files = commands_with_schemas();
    const Folder folder;
    const std::string help = run_tactics(folder, {"help", "json"}).out;
    for (const Command* command : commands()) {
        const std::string name(command->name);
        const bool told = holds(help, "/" + name + ".schema.json\n");
        EXPECT_EQ(files.contains(name), told) << name;
        const bool answers =
            std::any_of(command->flags.begin(), command->flags.end(), [](const Flag& f) { return f.name == "--json"; });
        EXPECT_EQ(told || name == "play" || name == "evaluate", answers) << name;
    }
    EXPECT_GE(files.size(), 13u);
}

}  // namespace
}  // namespace tactics::schemas_test
