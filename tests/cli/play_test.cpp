// `tactics play`: the real program, a simulated mouse and one that umockdev pretends.
#include <cmath>

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
