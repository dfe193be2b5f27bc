// SPDX-License-Identifier: Apache-2.0
// `tactics play`: the real program, a simulated mouse and one that umockdev pretends.
#include <cmath>
#include <cstdlib>

#include "tests/cli/converting.h"
#include "tests/cli/tick_rows.h"

namespace tactics::play_test {
namespace {

using namespace tests;

class Play : public Convert {
protected:
    Play() {
        EXPECT_EQ(
            convert({"disc.tif", "-q", "-o", "disc.height.png", "--set", "heightmap.height=2mm", "--paper", "80x60mm"}).code, 0);
    }
    Ending play(Words words) {
        words.insert(words.begin(), "play");
        return run_tactics(folder, words);
    }
};

TEST_F(Play, WritesEveryTickAndDrawsTheWay) {
    const Ending ending = play({"disc.height.png", "--seconds", "2", "--csv", "ticks.csv", "--plot", "way.svg", "--json"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.out, "\"gone\":0") && holds(ending.out, "\"not_finite\":0")) << ending.out;
    const std::string ticks = bytes_of(folder / "ticks.csv");
    EXPECT_TRUE(ticks.starts_with("time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n\n"));
    EXPECT_NEAR(static_cast<double>(lines_in(ticks)), 2000, 5);
    EXPECT_TRUE(holds(bytes_of(folder / "way.svg"), "<svg"));
    // The same again, byte by byte: nothing in it hangs on the clock.
    ASSERT_EQ(play({"disc.height.png", "--seconds", "2", "--csv", "again.csv", "-q"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "again.csv"), ticks);
}

TEST_F(Play, RepeatsARecordedWay) {
    write_bytes(folder / "hand.csv", "time_s,x_mm,y_mm\n0,10,20\n1,40,25\n2,20,30\n");
    const Ending ending = play({"disc.height.png", "--device", "recorded:hand.csv", "--csv", "ticks.csv", "-q"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(bytes_of(folder / "ticks.csv"), "\n1,40,25,")) << bytes_of(folder / "ticks.csv").substr(0, 200);
    // By the names of its columns, and to its end.
    write_bytes(folder / "long.csv", "note,y_mm,time_s,x_mm\n-,20,0,10\n-,25,15,40\n");
    ASSERT_EQ(play({"disc.height.png", "--device", "recorded:long.csv", "--csv", "ticks.csv", "-q"}).code, 0);
    EXPECT_NEAR(static_cast<double>(lines_in(bytes_of(folder / "ticks.csv"))), 15000, 5);
    EXPECT_TRUE(holds(bytes_of(folder / "ticks.csv"), "\n15,40,25,"));
    const auto message = [&](const char* csv) {
        write_bytes(folder / "bad.csv", csv);
        return play({"disc.height.png", "--device", "recorded:bad.csv"}).err;
    };
    EXPECT_TRUE(holds(message("time_ms,x_mm,y_mm\n0,1,1\n5,1,1\n"),
                      "bad.csv:1: its first line names the columns, and none of them is time_s"));
    EXPECT_TRUE(holds(message("time_s,x_mm,y_mm,finger_mm\n0,1,1,2\n1,1,1,1e300\n"), "bad.csv:3: 1e300 is beyond 100000"));
    EXPECT_TRUE(holds(message("0,1,1\n"), "a way has at least two moments"));
}

// Not the contours of it, of which most of a way touches none.
TEST_F(Play, ATableOfHeightsIsFeltAsItsSurface) {
    std::string csv = "x,y,z\n";
    for (int j = 0; j <= 10; ++j)
        for (int i = 0; i <= 10; ++i)
            csv += std::to_string(i) + "," + std::to_string(j) + "," + std::to_string(i * (10 - i)) + "\n";
    write_bytes(folder / "hill.csv", csv);
    const auto most_height = [&](Words words) {
        words.insert(words.begin(), "hill.csv");
        words.insert(words.end(), {"--seconds", "3", "--csv", "ticks.csv", "-q"});
        const Ending ending = play(words);
        EXPECT_EQ(ending.code, 0) << ending.err;
        double most = 0;
        for (const auto& tick : tick_rows(bytes_of(folder / "ticks.csv"))) most = std::max(most, tick.at(4));
        return most;
    };
    EXPECT_NEAR(most_height({"--z", "z", "--high", "4mm"}), 4, 0.05);
    // Contours where a way of drawing is asked for, and curves where no heights are.
    EXPECT_NEAR(most_height({"--z", "z", "--recipe", "photo"}), 0.5, 0.05);
    EXPECT_NEAR(most_height({"--y", "z"}), 0.5, 0.05);
}

// What is told of the place of a mouse without an overlay of its own, beside the truth: the paper's way is wrong where the hand
// is quick.
TEST_F(Play, ASensedMouseIsFoundByLearning) {
    write_bytes(folder / "plain.pgm", "P5\n300 40\n255\n" + std::string(300 * 40, 'x'));
    const auto error_of = [&](const std::string& fusion, const std::string& track) {
        const Ending ending =
            play({"plain.pgm", "--pitch",   "1mm", "--low",    "5mm",  "--high",  "15mm", "--device", "sensed",    "--speed",
                  "250",       "--seconds", "20",  "--fusion", fusion, "--track", track,  "--csv",    "ticks.csv", "--json"});
        EXPECT_EQ(ending.code, 0) << ending.err;
        const auto at = ending.out.find("\"place_error_mm\":");
        return at == std::string::npos ? -1 : std::stod(ending.out.substr(at + 17));
    };
    const double paper = error_of("paper", "paper.svg"), learning = error_of("learning", "learning.svg");
    EXPECT_GT(paper, 10);
    EXPECT_GT(learning, 0);
    EXPECT_LT(learning, 3);  // while it learns, too
    EXPECT_TRUE(bytes_of(folder / "ticks.csv")
                    .starts_with("time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n,true_x_mm,true_y_mm\n"));
    // Where the two are one there is one line, and it is longer where they are not.
    EXPECT_LT(bytes_of(folder / "learning.svg").size(), bytes_of(folder / "paper.svg").size());
    EXPECT_TRUE(holds(
        play({"plain.pgm", "--pitch", "1mm", "--low", "5mm", "--high", "15mm", "--device", "sensed", "--seconds", "700"}).err,
        "for at most 600 s"));
    EXPECT_TRUE(holds(play({"plain.pgm", "--device", "hid:", "--track", "x.svg"}).err, "take --device sensed"));
}

// A second play begins with what the first has found.
TEST_F(Play, KeepsWhatItLearnedOfAMouse) {
    const Words words = {"disc.height.png", "--device", "sensed", "--speed", "250", "--seconds", "4", "-q", "--json"};
    Words kept = words;
    kept.insert(kept.end(), {"--learned", "learned.txt"});
    const auto place_error = [](const Ending& ending) {
        const auto at = ending.out.find("\"place_error_mm\":");
        return at == std::string::npos ? -1 : std::strtod(ending.out.c_str() + at + 17, nullptr);
    };
    const double anew = place_error(play(words)), first = place_error(play(kept)), second = place_error(play(kept));
    EXPECT_EQ(first, anew);
    EXPECT_GT(second, 0);
    EXPECT_LT(second, anew / 2);
    EXPECT_EQ(place_error(play(words)), anew) << "a simulated mouse keeps nothing unasked";
    write_bytes(folder / "bad.txt", "4 N\n");
    Words bad = words;
    bad.insert(bad.end(), {"--learned", "bad.txt"});
    EXPECT_TRUE(holds(play(bad).err, "bad.txt: is not what was learned of a mouse; remove it")) << play(bad).err;
    Words nowhere = words;
    nowhere.insert(nowhere.end(), {"--learned", "nowhere/learned.txt"});
    EXPECT_EQ(play(nowhere).code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "nowhere"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--learned", "l.txt"}).err, "--learned: this mouse knows its place"));
    EXPECT_TRUE(
        holds(play({"disc.height.png", "--device", "sensed", "--fusion", "paper", "--learned", "l.txt"}).err, "learns nothing"));
}

TEST_F(Play, DrawsWhatIsStable) {
    const Ending ending = play({"--stable", "stable.svg", "--stiffness", "30"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    const std::string svg = bytes_of(folder / "stable.svg");
    for (const char* words : {"stiffness, N/mm", "damping, N s/m", "the most that comes to rest", "asked for, swings on"})
        EXPECT_TRUE(holds(svg, words)) << words;
    const Ending json = play({"--stable", "stable.svg", "--json"});
    EXPECT_TRUE(holds(json.out, "\"stable\":true") && holds(json.out, "{\"damping_ns_per_m\":8,\"stiffness_n_per_mm\":"))
        << json.out;
    // With a map the drawing is there, and the map is not played.
    EXPECT_EQ(play({"disc.height.png", "--stable", "again.svg", "--stiffness", "30"}).code, 1);
    EXPECT_EQ(bytes_of(folder / "again.svg"), svg);
}

TEST_F(Play, TakesTheMachineOfAFile) {
    const auto csv = [&](Words words) {
        words.insert(words.begin(), {"disc.height.png", "--seconds", "2", "-q", "--csv", "ticks.csv"});
        EXPECT_EQ(play(words).code, 0);
        return bytes_of(folder / "ticks.csv");
    };
    write_bytes(folder / "mouse.txt", "lever = heavy\nfinger = soft\n");
    const std::string by_file = csv({"--lever", "mouse.txt"});
    EXPECT_TRUE(by_file == csv({"--lever", "heavy", "--finger", "soft"}));
    EXPECT_FALSE(by_file == csv({"--lever", "mouse.txt", "--finger", "stiff"}));
    EXPECT_FALSE(by_file == csv({"--lever", "mouse.txt", "--edges", "2"}));
}

// The log is there while the play goes on, also for a program that is killed; and where it cannot be written that is told before
// anything moves.
TEST_F(Play, KeepsTheLogOfAPlayThatIsKilled) {
    const std::string command = "cd '" + (folder / "").string() +
                                "' && timeout -s KILL 1 '" TACTICS_PROGRAM
                                "' play disc.height.png --seconds 60 --real-time --csv ticks.csv -q 2>/dev/null";
    EXPECT_NE(std::system(command.c_str()), 0);
    EXPECT_EQ(names(), "disc.height.png disc.tif ticks.csv.part");
    EXPECT_GT(lines_in(bytes_of(folder / "ticks.csv.part")), 100u);
    const Ending ending = play({"disc.height.png", "--csv", "none/ticks.csv"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "none/ticks.csv: cannot be written (No such file or directory); name another file"))
        << ending.err;
    EXPECT_EQ(play({"disc.height.png", "--seconds", "1", "--csv", "/dev/full"}).code, 2);
    // The next play leaves it alone.
    EXPECT_TRUE(holds(play({"disc.height.png", "--seconds", "1", "--csv", "ticks.csv"}).err,
                      "ticks.csv.part has what was felt in a play that did not end"));
    EXPECT_GT(lines_in(bytes_of(folder / "ticks.csv.part")), 100u);
}

// A reader that does not read, or goes away, is no reason not to end.
TEST_F(Play, EndsWhoeverReadsItsLog) {
    const std::string begin = "cd '" + (folder / "").string() + "' && ",
                      program = "timeout -s KILL 20 '" TACTICS_PROGRAM "' play disc.height.png --seconds 5 ";
    EXPECT_EQ(std::system((begin + program + "--csv - 2>err | head -n 1 >out").c_str()), 0);
    EXPECT_TRUE(holds(bytes_of(folder / "err"), "5000 ticks")) << bytes_of(folder / "err");
    EXPECT_NE(std::system((begin + "mkfifo pipe && (sleep 9 <pipe &) && timeout -s INT 1 '" TACTICS_PROGRAM
                                   "' play disc.height.png --seconds 20 --csv pipe 2>err")
                              .c_str()),
              0);
    EXPECT_TRUE(holds(bytes_of(folder / "err"), "pipe: the log is not whole: nobody reads it")) << bytes_of(folder / "err");
    EXPECT_EQ(std::system((begin + "echo before >all && " + program + "--csv - -q >>all").c_str()), 0);
    EXPECT_TRUE(bytes_of(folder / "all").starts_with("before\ntime_s,"));
}

TEST_F(Play, WritesOverNothing) {
    const std::string map = bytes_of(folder / "disc.height.png");
    for (const char* flag : {"--csv", "--plot"})
        EXPECT_TRUE(holds(play({"disc.height.png", flag, "./disc.height.png"}).err, "would be written over"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--plot", "a.svg", "--stable", "a.svg"}).err, "a.svg is named for two outputs"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--csv", "-", "--json"}).err,
                      "standard output is named for two outputs (--json goes to standard output)"));
    EXPECT_TRUE(
        holds(play({"disc.height.png", "--plot", "svg:-", "--stable", "svg:-"}).err, "standard output is named for two outputs"));
    EXPECT_TRUE(bytes_of(folder / "disc.height.png") == map);
}

TEST_F(Play, RefusesFlagsThatWouldDoNothing) {
    EXPECT_TRUE(holds(play({"--stable", "s.svg", "--csv", "x.csv"}).err, "--csv: it is about a play; name a height map"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--device", "recorded:hand.csv", "--speed", "10"}).err,
                      "--speed: it is that of a simulated hand"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--fusion", "paper"}).err, "--fusion: this mouse knows its place"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--track", "t.svg"}).err, "--track: this mouse knows its place"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--part", "1mm,2mm"}).err, "--part: it is of the drawing of --plot"));
    EXPECT_TRUE(
        holds(play({"disc.height.png", "--plot", "p.svg", "--part", "2mm,1mm"}).err, "--part: it is from where to where"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--plot", "p.svg", "--part", "200mm,210mm"}).err,
                      "--part: the map has nothing there; it ends at 80 mm"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--plot", "p.svg", "--part", "70mm,75mm", "--seconds", "1", "-q"}).err,
                      "the first way over the map has nothing there; it goes from 0 to 25 mm"));
    EXPECT_TRUE(
        holds(play({"disc.height.png", "--device", "sensd", "--speed", "5"}).err, "there is no device \"sensd\" (sensed?)"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--dpi", "100"}).err, "--dpi: it is about a drawing"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--lever", "ligt"}).err, "there is no lever \"ligt\" (light?)"));
}

// The slowest loop that is allowed is no late one.
TEST_F(Play, ASlowLoopHasItsForce) {
    const Ending ending = play({"disc.height.png", "--rate", "100", "--stiffness", "0.2", "--seconds", "2", "--json"});
    EXPECT_TRUE(holds(ending.out, "\"too_late\":0")) << ending.out << ending.err;
}

TEST_F(Play, RefusesWhatWouldTremble) {
    const Ending printed = play({"disc.height.png", "--damping-sign", "as_printed", "--damping", "3"});
    EXPECT_EQ(printed.code, 1);
    EXPECT_TRUE(holds(printed.err, "--damping-sign: ") &&
                holds(printed.err, "comes to rest: --stiffness 1 --damping 3 --damping-sign corrected"))
        << printed.err;
    const Ending hard = play({"disc.height.png", "--stiffness", "100"});
    EXPECT_EQ(hard.code, 1);
    EXPECT_TRUE(holds(hard.err, "--stiffness: ")) << hard.err;
}

// A picture, a figure and a table reach the finger as they would by way of a file of heights.
TEST_F(Play, WhatIsDrawnFirstIsFeltAsFromAFile) {
    write_bytes(folder / "t.csv", "a,b\n1,2\n2,5\n4,3\n");
    ASSERT_EQ(convert({"disc.tif", "-q", "-r", "diagram", "-o", "disc.svg"}).code, 0);
    for (const Words& source : {Words{"disc.tif", "-r", "diagram"}, Words{"disc.svg"}, Words{"t.csv"}}) {
        Words made = source, felt = source;
        made.insert(made.end(), {"-q", "--bare", "--width", "150mm", "-o", "between.height.tif", "--set",
                                 "heightmap-tiff.samples=decimal", "--set", "heightmap-tiff.height=0.8mm"});
        ASSERT_EQ(convert(made).code, 0) << source[0];
        ASSERT_EQ(play({"between.height.tif", "--seconds", "1", "--csv", "between.csv", "-q"}).code, 0);
        felt.insert(felt.end(), {"--width", "150mm", "--high", "0.8mm", "--seconds", "1", "--csv", "felt.csv"});
        const Ending ending = play(felt);
        EXPECT_EQ(ending.code, 0) << ending.err;
        EXPECT_EQ(bytes_of(folder / "felt.csv"), bytes_of(folder / "between.csv")) << source[0];
    }
    // A file with heights is played directly, and so is a picture for which heights are given.
    EXPECT_FALSE(holds(play({"between.height.tif", "--seconds", "0.1"}).err, "recipe"));
    EXPECT_TRUE(holds(play({"disc.tif", "--pitch", "1mm", "--seconds", "0.1"}).err, "it tells no heights"));
    EXPECT_TRUE(holds(play({"disc.tif", "--seconds", "0.1"}).err, "disc.tif: recipe "));
    EXPECT_TRUE(holds(play({"t.csv", "--low", "1mm"}).err, "--low: the lines of a drawing stand on a ground of 0 mm"));
    write_bytes(folder / "blank.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='50mm' height='50mm'/>");
    const Ending blank = play({"blank.svg"});
    EXPECT_EQ(blank.code, 2);
    EXPECT_TRUE(holds(blank.err, "blank.svg: nothing is drawn of it that could be felt")) << blank.err;
}

TEST_F(Play, SaysWhatIsWrong) {
    EXPECT_TRUE(holds(play({}).err, "name one picture, drawing, model or height map"));
    EXPECT_EQ(play({"missing.png"}).code, 2);
    EXPECT_TRUE(holds(play({"disc.height.png", "--device", "hid:"}).err, "there is no haptic mouse; plug it in"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--device", "mouse"}).err, "there is no device \"mouse\""));
    EXPECT_TRUE(
        holds(play({"disc.height.png", "--wall", "look_ahead"}).err, "there is no way \"look_ahead\" into a wall (look-ahead?)"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--finger", "hard"}).err, "there is no finger \"hard\""));
    EXPECT_TRUE(holds(play({"disc.height.png", "--radius", "1m"}).err, "it is a length from 0 to 20mm"));
    write_bytes(folder / "bad.csv", "0,1,2\n1,x,2\n");
    EXPECT_TRUE(holds(play({"disc.height.png", "--device", "recorded:bad.csv"}).err, "bad.csv:2: a line is time_s,x_mm,y_mm"));
    EXPECT_EQ(play({"disc.height.png", "--lever", "none.txt"}).code, 2);
    EXPECT_EQ(names(), "bad.csv disc.height.png disc.tif");
}

}  // namespace
}  // namespace tactics::play_test
