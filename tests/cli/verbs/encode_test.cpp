// SPDX-License-Identifier: Apache-2.0
// `tactics encode` and `tactics decode`, and .felt files in all that reads heights and ways.
#include <cmath>
#include <fstream>
#include <sstream>

#include "tactics/text/number.h"
#include "tests/cli/converting.h"

namespace tactics::encode_test {
namespace {

using namespace tests;

class Encode : public Convert {
protected:
    Ending run(Words words) { return run_tactics(folder, words); }

    // A surface that a simulated hand feels on an arm, and what was felt.
    void felt() {
        std::string table = "x,y,z\n";
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x)
                table += std::to_string(x) + "," + std::to_string(y) + "," +
                         to_text(std::round(1000 * (std::sin(x / 2.0) + std::cos(y / 3.0))) / 1000) + "\n";
        write_bytes(folder / "surface.csv", table);
        const Ending ending =
            run({"play", "surface.csv", "--z", "z", "--device", "arm", "--seconds", "12", "--csv", "ticks.csv", "-q"});
        ASSERT_EQ(ending.code, 0) << ending.err;
    }
};

std::vector<std::vector<double>> rows_of(const std::string& csv, const std::vector<std::string>& wanted) {
    std::istringstream lines(csv);
    std::vector<std::string> names;
    std::vector<std::vector<double>> rows;
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> cells;
        std::istringstream parts(line);
        for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
        if (names.empty()) {
            names = cells;
            continue;
        }
        std::vector<double> row;
        for (const std::string& name : wanted)
            row.push_back(
                std::stod(cells[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())]));
        rows.push_back(row);
    }
    return rows;
}

double number_in(const std::string& json, const std::string& name) {
    const auto at = json.find("\"" + name + "\":");
    return at == std::string::npos ? NAN : std::stod(json.substr(at + name.size() + 3));
}

const std::vector<std::string> kColumns{"time_s", "x_mm", "y_mm", "finger_mm", "force_n", "force_x_n", "force_y_n"};

TEST_F(Encode, ARecordingComesBackNumberForNumber) {
    felt();
    const Ending packed = run({"encode", "ticks.csv", "-o", "ticks.felt"});
    ASSERT_EQ(packed.code, 0) << packed.err;
    EXPECT_TRUE(holds(packed.err, "ticks.csv: left out: surface_mm, reference_mm\n")) << packed.err;
    EXPECT_TRUE(holds(packed.err, "all forces as they are")) << packed.err;
    ASSERT_EQ(run({"decode", "ticks.felt", "-o", "back.csv", "-q"}).code, 0);
    EXPECT_EQ(rows_of(bytes_of(folder / "back.csv"), kColumns), rows_of(bytes_of(folder / "ticks.csv"), kColumns));
    EXPECT_LT(bytes_of(folder / "ticks.felt").size(), bytes_of(folder / "back.csv").size() / 6);
    // The same again gives the same bytes.
    ASSERT_EQ(run({"encode", "back.csv", "-o", "again.felt", "-q"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "again.felt"), bytes_of(folder / "ticks.felt"));
}

// The product's own scene: at 10 % no more than 81 of 1000 ticks tell a force, all within the threshold, and no stretch gives out
// more work than it is told.
TEST_F(Encode, TenPercentOfAFeltSurfaceNeedFewForces) {
    felt();
    const auto truth = rows_of(bytes_of(folder / "ticks.csv"), kColumns);
    for (const char* predict : {"hold", "linear"}) {
        const Ending packed =
            run({"encode", "ticks.csv", "-o", "ticks.felt", "--deadband", "10%", "--predict", predict, "--json"});
        ASSERT_EQ(packed.code, 0) << packed.err;
        EXPECT_LE(number_in(packed.out, "told_per_1000"), 81) << packed.out;
        EXPECT_LE(number_in(packed.out, "most_of_threshold"), 1);
        EXPECT_LE(number_in(packed.out, "work_added_nmm"), 0.1);
        ASSERT_EQ(run({"decode", "ticks.felt", "-o", "back.csv", "-q"}).code, 0);
        const auto back = rows_of(bytes_of(folder / "back.csv"), kColumns);
        ASSERT_EQ(back.size(), truth.size());
        std::vector<double> work{0};
        for (std::size_t i = 0; i < truth.size(); ++i) {
            double missed = 0, size = 0, added = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                // z of the force is force_n, of the place finger_mm
                const std::size_t force = axis == 2 ? 4 : 5 + axis, place = axis == 2 ? 3 : 1 + axis;
                const double off = back[i][force] - truth[i][force];
                missed += off * off;
                size += truth[i][force] * truth[i][force];
                if (i + 1 < truth.size()) added += off * (truth[i + 1][place] - truth[i][place]);
            }
            ASSERT_LE(std::sqrt(missed), std::max(0.1 * std::sqrt(size), 0.01) + 1e-9) << i;
            work.push_back(work.back() + added);
        }
        double least = 0;
        for (const double until : work) {
            ASSERT_LE(until - least, 0.1 + 1e-6);
            least = std::min(least, until);
        }
    }
}

TEST_F(Encode, APartOfARecordingAndAWayAreTakenFromIt) {
    felt();
    ASSERT_EQ(run({"encode", "ticks.csv", "-o", "ticks.felt", "-q"}).code, 0);
    ASSERT_EQ(run({"decode", "ticks.felt", "--part", "5,6.5", "-o", "part.csv", "-q"}).code, 0);
    const auto part = rows_of(bytes_of(folder / "part.csv"), {"time_s"});
    EXPECT_EQ(part.size(), 1501u);
    EXPECT_EQ(part.front()[0], 5);
    EXPECT_EQ(part.back()[0], 6.5);
    // Played as the table is.
    for (const char* way : {"recorded:ticks.csv", "recorded:ticks.felt"})
        ASSERT_EQ(run({"play", "disc.tif", "--device", way, "--csv", std::string(way).substr(9) + ".log", "-q"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "ticks.csv.log"), bytes_of(folder / "ticks.felt.log"));
}

TEST_F(Encode, HeightsComeBackInAllFilesOfHeights) {
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "a.height.png", "-o", "a.felt", "--paper", "80x60mm"}).code, 0);
    EXPECT_LT(bytes_of(folder / "a.felt").size(), bytes_of(folder / "a.height.png").size());
    ASSERT_EQ(run({"decode", "a.felt", "-q", "-o", "b.png"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "b.png"), bytes_of(folder / "a.height.png"));
    ASSERT_EQ(run({"relief", "a.felt", "-q", "-o", "c.png", "-o", "c.felt"}).code, 0);
    ASSERT_EQ(run({"relief", "a.height.png", "-q", "-o", "d.png", "-o", "d.felt"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "c.png"), bytes_of(folder / "d.png"));
    EXPECT_EQ(bytes_of(folder / "c.felt"), bytes_of(folder / "d.felt"));
    ASSERT_EQ(run({"encode", "a.height.png", "-q", "-o", "e.felt"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "e.felt"), bytes_of(folder / "d.felt"));
    // A part is cut from the whole.
    const Ending part = run({"decode", "a.felt", "--part", "10mm,20mm,30mm,25mm", "-o", "part.png"});
    EXPECT_TRUE(holds(part.err, "a.felt: 200 x 50 heights 0.1 mm apart")) << part.err;
    // And everything else takes it.
    EXPECT_EQ(run({"play", "a.felt", "--seconds", "1", "-q"}).code, 0);
    EXPECT_EQ(run({"check", "a.felt", "-q"}).err, run({"check", "a.height.png", "-q"}).err);
    EXPECT_EQ(convert({"a.felt", "-q", "-o", "page.svg"}).code, 0);
}

TEST_F(Encode, SoftIsCoarserAndSaysSo) {
    felt();
    ASSERT_EQ(run({"encode", "ticks.csv", "-q", "-o", "strong.felt"}).code, 0);
    const Ending soft = run({"encode", "ticks.csv", "-o", "soft.felt", "--device", "omni", "--json"});
    ASSERT_EQ(soft.code, 0) << soft.err;
    EXPECT_EQ(number_in(soft.out, "place_step_mm"), 0.055);
    EXPECT_EQ(number_in(soft.out, "force_step_n"), 0.01);
    EXPECT_TRUE(holds(soft.out, "\"device\":\"omni\""));
    EXPECT_LT(bytes_of(folder / "soft.felt").size(), bytes_of(folder / "strong.felt").size() / 2);
    // Packed again from what is packed already.
    ASSERT_EQ(run({"encode", "strong.felt", "-q", "-o", "soft-again.felt", "--device", "omni"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "soft-again.felt"), bytes_of(folder / "soft.felt"));
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "a.height.png", "--paper", "80x60mm"}).code, 0);
    const Ending heights = run({"encode", "a.height.png", "-o", "soft-map.felt", "--device", "omni"});
    EXPECT_TRUE(holds(heights.err, "of 11 levels from 0 to 0.5 mm")) << heights.err;  // 0.5 mm / 0.055 mm = 9.1
}

TEST_F(Encode, HelpTellsTheLayoutAsItIs) {
    write_bytes(folder / "ticks.csv", "time_s,x_mm,y_mm,force_n\n0,1,1,0.5\n0.001,1,1,0.5\n");
    ASSERT_EQ(run({"encode", "ticks.csv", "-q", "-o", "ticks.felt"}).code, 0);
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "a.felt"}).code, 0);
    const std::string help = run({"help", "felt"}).out;
    for (const auto& [name, what] : {std::pair<const char*, const char*>{"ticks.felt", "a recording"}, {"a.felt", "heights"}}) {
        const std::string bytes = bytes_of(folder / name);
        std::string begin;
        for (const char byte : bytes.substr(0, 8)) {
            constexpr std::string_view kDigits = "0123456789ABCDEF";
            const auto value = static_cast<unsigned char>(byte);
            begin += std::string(begin.empty() ? "" : " ") + kDigits[value / 16] + kDigits[value % 16];
        }
        EXPECT_TRUE(holds(help, "0  8  " + begin + " (hexadecimal)")) << begin;
        const int facts = static_cast<unsigned char>(bytes[10]) + 256 * static_cast<unsigned char>(bytes[11]);
        EXPECT_TRUE(holds(help, std::string("Facts of ") + what + ", " + std::to_string(facts) + " bytes")) << facts;
    }
}

TEST_F(Encode, SaysWhatIsWrong) {
    write_bytes(folder / "ticks.csv", "time_s,x_mm,y_mm,force_n\n0,1,1,0.5\n0.001,1,1,0.5\n");
    write_bytes(folder / "back.csv", "time_s,x_mm,y_mm,force_n\n0.002,1,1,0.5\n0.001,1,1,0.5\n");
    write_bytes(folder / "word.csv", "time_s,x_mm,y_mm,force_n\n0,1,1,0.5\n0.001,1,much,0.5\n");
    write_bytes(folder / "none.csv", "time_s,x_mm,force_n\n0,1,0.5\n0.001,1,0.5\n");
    ASSERT_EQ(run({"encode", "ticks.csv", "-q", "-o", "ticks.felt"}).code, 0);
    std::string bytes = bytes_of(folder / "ticks.felt");
    write_bytes(folder / "cut.felt", bytes.substr(0, bytes.size() - 3));
    const std::vector<std::pair<Words, std::string>> faults = {
        {{"encode"}, "encode: name one recording"},
        {{"encode", "ticks.csv"}, "encode: say where to write it"},
        {{"encode", "ticks.csv", "-o", "ticks.csv"}, "--output: ticks.csv is the input"},
        {{"encode", "ticks.csv", "-o", "a.felt", "--deadband", "60%"}, "--deadband: it cannot be \"60%\""},
        {{"encode", "ticks.csv", "-o", "a.felt", "--predict", "hold"}, "--predict: without --deadband"},
        {{"encode", "ticks.csv", "-o", "a.felt", "--device", "spoon"}, "--device"},
        {{"encode", "disc.tif", "-o", "a.felt", "--deadband", "10%"}, "--deadband: it is about forces"},
        {{"encode", "back.csv", "-o", "a.felt"}, "back.csv:3: time goes back here"},
        {{"encode", "word.csv", "-o", "a.felt"}, "word.csv:3: \"much\" is no number"},
        {{"encode", "none.csv", "-o", "a.felt"}, "none.csv: has no column y_mm"},
        {{"decode", "ticks.felt", "-o", "a.png"}, "--output: \"a.png\" must end in .csv"},
        {{"decode", "ticks.felt", "--part", "3"}, "--part: it cannot be \"3\"; it is FROM,TO"},
        {{"decode", "ticks.felt", "--part", "3,4"}, "--part: there is no tick between 3 and 4 s"},
        {{"decode", "cut.felt"}, "cut.felt: is damaged: it is cut off"},
        {{"decode", "disc.tif"}, "disc.tif: is no .felt file"},
        {{"relief", "ticks.felt", "-o", "a.png"}, "ticks.felt: holds a recording and no heights"},
    };
    for (const auto& [words, message] : faults) {
        const Ending ending = run(words);
        EXPECT_NE(ending.code, 0) << message;
        EXPECT_TRUE(holds(ending.err, message)) << ending.err;
    }
}

}  // namespace
}  // namespace tactics::encode_test
