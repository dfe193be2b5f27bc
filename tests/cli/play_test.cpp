// `tactics play`: the real program, a simulated mouse and one that umockdev pretends.
#include <cmath>
#include <cstdlib>

#include "tests/cli/converting.h"

namespace tactics {
namespace {

using namespace tests;

class Play : public Convert {
protected:
    Play() { EXPECT_EQ(convert({"disc.tif", "-q", "-o", "disc.height.png", "--set", "heightmap.height=2mm", "--paper", "80x60mm"}).code, 0); }
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
}

// What is told of the place of a mouse without an overlay of its own, beside the truth: the paper's way is wrong where the hand is quick.
TEST_F(Play, ASensedMouseIsFoundByLearning) {
    write_bytes(folder / "plain.pgm", "P5\n300 40\n255\n" + std::string(300 * 40, 'x'));
    const auto error_of = [&](const std::string& fusion, const std::string& track) {
        const Ending ending = play({"plain.pgm", "--pitch", "1mm", "--low", "5mm", "--high", "15mm", "--device", "sensed", "--speed", "250", "--seconds", "20", "--fusion", fusion, "--track", track, "--csv",
                                    "ticks.csv", "--json"});
        EXPECT_EQ(ending.code, 0) << ending.err;
        const auto at = ending.out.find("\"place_error_mm\":");
        return at == std::string::npos ? -1 : std::stod(ending.out.substr(at + 17));
    };
    const double paper = error_of("paper", "paper.svg"), learning = error_of("learning", "learning.svg");
    EXPECT_GT(paper, 10);
    EXPECT_GT(learning, 0);
    EXPECT_LT(learning, 3);  // while it learns, too
    EXPECT_TRUE(bytes_of(folder / "ticks.csv").starts_with("time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n,true_x_mm,true_y_mm\n"));
    // Where the two are one there is one line, and it is longer where they are not.
    EXPECT_LT(bytes_of(folder / "learning.svg").size(), bytes_of(folder / "paper.svg").size());
    EXPECT_TRUE(holds(play({"plain.pgm", "--pitch", "1mm", "--low", "5mm", "--high", "15mm", "--device", "sensed", "--seconds", "700"}).err, "for at most 600 s"));
    EXPECT_TRUE(holds(play({"plain.pgm", "--device", "hid:", "--track", "x.svg"}).err, "take --device sensed"));
}

TEST_F(Play, DrawsWhatIsStable) {
    const Ending ending = play({"--stable", "stable.svg", "--stiffness", "30"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    const std::string svg = bytes_of(folder / "stable.svg");
    for (const char* words : {"stiffness, N/mm", "damping, N s/m", "the most that comes to rest", "with the sign as printed", "asked for"}) EXPECT_TRUE(holds(svg, words)) << words;
    // With a map the drawing is there, and the map is not played.
    EXPECT_EQ(play({"disc.height.png", "--stable", "again.svg", "--stiffness", "30"}).code, 1);
    EXPECT_EQ(bytes_of(folder / "again.svg"), svg);
}

TEST_F(Play, TakesTheMachineOfAFile) {
    const auto csv = [&](Words words) {
        words.insert(words.begin(), {"disc.height.png", "--seconds", "1", "-q", "--csv", "ticks.csv"});
        EXPECT_EQ(play(words).code, 0);
        return bytes_of(folder / "ticks.csv");
    };
    write_bytes(folder / "mouse.txt", "lever = heavy\nfinger = soft\n");
    const std::string by_file = csv({"--lever", "mouse.txt"});
    EXPECT_EQ(by_file, csv({"--lever", "heavy", "--finger", "soft"}));
    EXPECT_NE(by_file, csv({"--lever", "mouse.txt", "--finger", "stiff"}));
    EXPECT_NE(by_file, csv({"--lever", "mouse.txt", "--edges", "2"}));
}

// The log is there while the play goes on, also for a program that is killed; and where it cannot be written that is told before anything moves.
TEST_F(Play, KeepsTheLogOfAPlayThatIsKilled) {
    const std::string command = "cd '" + (folder / "").string() + "' && timeout -s KILL 1 '" TACTICS_PROGRAM "' play disc.height.png --seconds 60 --real-time --csv ticks.csv -q 2>/dev/null";
    EXPECT_NE(std::system(command.c_str()), 0);
    EXPECT_EQ(names(), "disc.height.png disc.tif ticks.csv.part");
    EXPECT_GT(lines_in(bytes_of(folder / "ticks.csv.part")), 100u);
    const Ending ending = play({"disc.height.png", "--csv", "none/ticks.csv"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "none/ticks.csv.part: cannot be written (No such file or directory); name another file")) << ending.err;
    EXPECT_EQ(play({"disc.height.png", "--seconds", "1", "--csv", "/dev/full"}).code, 2);
}

TEST_F(Play, RefusesWhatWouldTremble) {
    const Ending printed = play({"disc.height.png", "--damping-sign", "as_printed", "--damping", "3"});
    EXPECT_EQ(printed.code, 1);
    EXPECT_TRUE(holds(printed.err, "--damping-sign: ") && holds(printed.err, "comes to rest: --stiffness 1 --damping 3 --damping-sign corrected")) << printed.err;
    const Ending hard = play({"disc.height.png", "--stiffness", "100"});
    EXPECT_EQ(hard.code, 1);
    EXPECT_TRUE(holds(hard.err, "--stiffness: ")) << hard.err;
}

TEST_F(Play, SaysWhatIsWrong) {
    EXPECT_TRUE(holds(play({}).err, "name one height map"));
    EXPECT_EQ(play({"missing.png"}).code, 2);
    EXPECT_TRUE(holds(play({"disc.height.png", "--device", "hid:"}).err, "there is no haptic mouse; plug it in"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--device", "mouse"}).err, "there is no mouse \"mouse\""));
    EXPECT_TRUE(holds(play({"disc.height.png", "--wall", "look_ahead"}).err, "there is no way \"look_ahead\" into a wall (look-ahead?)"));
    EXPECT_TRUE(holds(play({"disc.height.png", "--finger", "hard"}).err, "there is no finger \"hard\""));
    EXPECT_TRUE(holds(play({"disc.height.png", "--radius", "1m"}).err, "it is a length from 0 to 20mm"));
    write_bytes(folder / "bad.csv", "0,1,2\n1,x,2\n");
    EXPECT_TRUE(holds(play({"disc.height.png", "--device", "recorded:bad.csv"}).err, "bad.csv:2: a line is time_s,x_mm,y_mm"));
    EXPECT_EQ(play({"disc.height.png", "--lever", "none.txt"}).code, 2);
    EXPECT_EQ(names(), "bad.csv disc.height.png disc.tif");
}

}  // namespace
}  // namespace tactics
