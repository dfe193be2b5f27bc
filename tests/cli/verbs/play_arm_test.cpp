// SPDX-License-Identifier: Apache-2.0
// `tactics play` of a table on a simulated arm, through the program.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <tuple>

#include "tactics/point3.h"
#include "tests/cli/converting.h"
#include "tests/cli/tick_rows.h"

namespace tactics::play_arm_test {
namespace {

using namespace tests;

class PlayArm : public Convert {
protected:
    PlayArm() {
        std::string csv = "time (s),speed (m/s)\n";
        for (int i = 0; i <= 50; ++i) csv += std::to_string(i * 0.1) + "," + std::to_string(3 + 2 * std::sin(i * 0.12)) + "\n";
        write_bytes(folder / "data.csv", csv);
    }
    Ending play(Words words) {
        words.insert(words.begin(), {"play", "data.csv", "--device", "arm"});
        return run_tactics(folder, words);
    }
    double number(const std::string& json, const std::string& name) {
        const auto at = json.find("\"" + name + "\":");
        return at == std::string::npos ? NAN : std::stod(json.substr(at + name.size() + 3));
    }
};

TEST_F(PlayArm, AHandFindsACurveFollowsItToItsEndAndStopsAtATick) {
    const Ending ending = play({"--hand", "trace", "--json"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_GT(number(ending.out, "curve_followed"), 0.9) << ending.out;
    EXPECT_LT(number(ending.out, "curve_rms_mm"), 2) << ending.out;
    EXPECT_LT(number(ending.out, "end_off_mm"), 2) << ending.out;
    EXPECT_LT(number(ending.out, "tick_off_mm"), 0.5) << ending.out;
    EXPECT_LE(number(ending.out, "most_force_n"), 3.3);
    ASSERT_EQ(play({"--hand", "trace", "--plot", "way.svg", "-q"}).code, 0);
    EXPECT_TRUE(holds(bytes_of(folder / "way.svg"), "way of the finger"));
    // The same again, byte by byte.
    EXPECT_EQ(play({"--hand", "trace", "--json"}).out, ending.out);
}

// Steep, with corners as sharp as a needle's, winding, closed: along all of it, from where it begins.
TEST_F(PlayArm, AHandFollowsCurvesOfAnyCourse) {
    const struct {
        const char* name;
        int points;
        std::pair<double, double> (*at)(int);
    } curves[] = {
        {"exponential", 100, [](int i) { return std::pair(i * 0.1, std::exp(i * 0.1)); }},
        {"step", 4, [](int i) { return std::pair(i == 0   ? 0.0
                                                 : i == 3 ? 10.0
                                                          : 5.0,
                                                 i < 2 ? 0.0 : 1.0); }},
        {"needles", 9, [](int i) { return std::pair(double(i), double(i % 2)); }},
        {"spiral", 126, [](int i) { return std::pair((1 + i * 0.1) * std::cos(i * 0.1), (1 + i * 0.1) * std::sin(i * 0.1)); }},
        {"square wave", 21, [](int i) { return std::pair(double(i), double(i / 2 % 2)); }},  // between corners to and fro no more
        {"circle", 101, [](int i) { return std::pair(std::cos(i * 0.062831853), std::sin(i * 0.062831853)); }},
    };
    for (const auto& curve : curves)
        for (const char* arm : {"omni", "phantom"}) {
            std::string csv = "x,y\n";
            for (int i = 0; i < curve.points; ++i) {
                const auto [x, y] = curve.at(i);
                csv += std::to_string(x) + "," + std::to_string(y) + "\n";
            }
            write_bytes(folder / "data.csv", csv);
            const Ending ending = play({"--hand", "trace", "--fixture", "r1", "--arm", arm, "--seconds", "300", "--json"});
            EXPECT_GT(number(ending.out, "curve_followed"), 0.99) << curve.name << arm << ending.out;
            EXPECT_LT(number(ending.out, "curve_rms_mm"), 1.3) << curve.name << arm << ending.out;
            const bool closed = holds(ending.out, "\"curve_closed\":true");
            EXPECT_EQ(closed, std::string(curve.name) == "circle") << arm << ending.out;
            if (!closed) {
                EXPECT_LT(number(ending.out, "end_off_mm"), 2) << curve.name << arm << ending.out;
            }
        }
}

// Where a curve runs along the axis, what holds the finger is no tick; one that ends beside a tick leaves it alone.
TEST_F(PlayArm, AHandTakesNothingElseForATick) {
    double (*const curves[])(double) = {[](double x) { return std::exp(-3 * (x - 5) * (x - 5)); },
                                        [](double x) { return std::abs(std::sin(3 * x)); }, [](double x) { return 9 - 0.2 * x; },
                                        [](double x) { return (x - 5) * (x - 5); }};
    for (const auto& curve : curves)
        for (const char* arm : {"omni", "phantom"}) {
            std::string csv = "x,y\n";
            for (int i = 0; i <= 200; ++i) csv += std::to_string(i * 0.05) + "," + std::to_string(curve(i * 0.05)) + "\n";
            write_bytes(folder / "data.csv", csv);
            const Ending ending = play({"--hand", "trace", "--arm", arm, "--seconds", "300", "--json"});
            EXPECT_TRUE(holds(ending.out, "\"hand_ended\":true")) << ending.out;
            const double off = number(ending.out, "tick_off_mm");
            EXPECT_TRUE(std::isnan(off) || off < 0.5) << arm << ending.out;
        }
}

// Where a curve comes down at each tick, or lies on half of the axis, it still knows a tick by its sides; without axes there is
// none.
TEST_F(PlayArm, AHandFindsATickBesideACurve) {
    double (*const curves[])(double) = {[](double x) { return std::abs(std::fmod(x, 2) - 1) < 0.5 ? 0.0 : 3.0; },
                                        [](double x) { return 3 - 3 * std::abs(std::fmod(x, 2) - 1); },
                                        [](double x) { return std::max(0.0, std::abs(x - 5) - 2.5); },
                                        [](double x) { return std::max(0.0, 0.4 * (x - 5)); }};
    for (const auto& curve : curves)
        for (const char* arm : {"omni", "phantom"}) {
            std::string csv = "x,y\n";
            for (int i = 0; i <= 40; ++i) csv += std::to_string(i * 0.25) + "," + std::to_string(curve(i * 0.25)) + "\n";
            write_bytes(folder / "data.csv", csv);
            const Ending ending = play({"--hand", "trace", "--arm", arm, "--seconds", "400", "--json"});
            EXPECT_LT(number(ending.out, "tick_off_mm"), 0.3) << arm << ending.out;
            const Ending without = play({"--hand", "trace", "--arm", arm, "--seconds", "400", "--feel", "wall,curves", "--json"});
            EXPECT_TRUE(std::isnan(number(without.out, "tick_off_mm"))) << arm << without.out;
        }
}

// An upright line between the ways on which the hand looks, or none that is felt, and a walk that is cut short.
TEST_F(PlayArm, SaysWhatItHasNotFoundOrEnded) {
    EXPECT_TRUE(holds(play({"--hand", "trace", "--feel", "wall,axes"}).err, "the hand found no curve"));
    EXPECT_TRUE(holds(play({"--hand", "trace", "--feel", "wall,axes", "--json"}).out, "\"curve_found\":false"));
    const Ending cut = play({"--hand", "trace", "--seconds", "12"});
    EXPECT_TRUE(holds(cut.err, "the hand was still under way when the seconds ended; give it more (--seconds)")) << cut.err;
    EXPECT_TRUE(holds(play({"--hand", "trace", "--seconds", "12", "--json"}).out, "\"hand_ended\":false"));
    EXPECT_FALSE(holds(play({"--hand", "trace", "--seconds", "200"}).err, "still under way"));
    EXPECT_FALSE(holds(play({"--hand", "to-and-fro", "--seconds", "2"}).err, "still under way"));
}

TEST_F(PlayArm, WritesEveryTickWithTheWholeForce) {
    ASSERT_EQ(play({"--seconds", "2", "--csv", "ticks.csv", "-q"}).code, 0);
    const std::string ticks = bytes_of(folder / "ticks.csv");
    EXPECT_TRUE(ticks.starts_with("time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n,force_x_n,force_y_n\n"));
    EXPECT_NEAR(static_cast<double>(lines_in(ticks)), 2000, 5);
    // Never over what the arm gives, nor quicker than it may grow.
    for (const auto& values : tick_rows(ticks)) ASSERT_LE(std::hypot(values.at(6), values.at(7), values.at(8)), 3.3 + 1e-3);
}

// Where a value is: x to the right of the corner, y upwards, z off the plane, along axes that stand on each other.
TEST_F(PlayArm, TellsTheScaleAndWhereItIs) {
    const Ending ending = play({"--seconds", "0.1", "--json", "--plane", "0,1,1,10", "--arm", "phantom"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    const auto scene = ending.out.find("\"scene\":");
    ASSERT_NE(scene, std::string::npos) << ending.out;
    const std::string x = ending.out.substr(ending.out.find("\"x\":", scene)),
                      y = ending.out.substr(ending.out.find("\"y\":", scene));
    for (const auto& [axis, low, high] : {std::tuple(x, 0.0, 5.0), std::tuple(y, 1.1, 4.9)}) {
        EXPECT_LE(number(axis, "low"), low);
        EXPECT_GE(number(axis, "high"), high);
        EXPECT_NEAR(number(axis, "mm_each") * (number(axis, "high") - number(axis, "low")), number(axis, "mm"), 1e-5);
    }
    const auto triple = [&](const char* name) {
        const std::string from = ending.out.substr(ending.out.find("\"" + std::string(name) + "\":[") + std::strlen(name) + 4);
        Point3 at;
        EXPECT_EQ(std::sscanf(from.c_str(), "%lf,%lf,%lf", &at.x, &at.y, &at.z), 3) << from;
        return at;
    };
    const Point3 right = triple("right"), down = triple("down"), out = triple("out"), corner = triple("corner_mm");
    EXPECT_NEAR(length_of(right), 1, 1e-5);
    EXPECT_NEAR(length_of(cross(right, down) + out), 0, 1e-5);  // y goes downwards
    for (const Point3& at : {corner, corner + number(x, "mm") * right, corner + number(y, "mm") * down})
        EXPECT_NEAR(at.y + at.z + 10, 0, 1e-4);  // on the plane
    EXPECT_GT(out.y + out.z, 1.4);
}

TEST_F(PlayArm, TellsWhatAnUpdateTookByTheClockOnly) {
    const Ending simulated = play({"--seconds", "0.1", "--json"}), real = play({"--seconds", "0.1", "--json", "--real-time"});
    for (const char* name : {"update_p50_us", "update_p999_us", "ready_s"}) {
        EXPECT_TRUE(std::isnan(number(simulated.out, name))) << name;
        EXPECT_GT(number(real.out, name), 0) << name;
    }
}

// Whatever it is, it is felt within the limits or refused with the line: never without an end.
TEST_F(PlayArm, PoorTablesAreFeltOrRefused) {
    const auto felt = [&](const std::string& csv) {
        write_bytes(folder / "data.csv", csv);
        const Ending ending = play({"--feel", "curves,points", "--seconds", "10", "--json"});
        EXPECT_EQ(ending.code, 0) << csv << ending.err;
        EXPECT_EQ(number(ending.out, "not_finite"), 0) << csv;
        EXPECT_GT(number(ending.out, "touched"), 0) << csv;
        EXPECT_LE(number(ending.out, "most_force_n"), 3.3 + 1e-3) << csv;
    };
    felt("x,y\n1,2\n");
    felt("x,y\n1,2\n1,2\n1,2\n");
    felt("x,y\n3,1\n3,2\n3,9\n");
    felt("x,y\n1,2\n2,2\n9,2\n");
    felt("x,y\n5,1\n2,4\n2,4\n7,1\n2,8\n2,1\n");
    const auto refused = [&](const std::string& csv, const char* why) {
        write_bytes(folder / "data.csv", csv);
        const Ending ending = play({});
        EXPECT_EQ(ending.code, 2) << csv;
        EXPECT_TRUE(holds(ending.err, why)) << ending.err;
    };
    refused("x,y\n0,1\n1,inf\n2,3\n", "data.csv:3: y is \"inf\", which no axis reaches");
    refused("x,y\n0,1\n1,1e308\n2,-1e308\n", "too large to be written at an axis");
    refused("x,y\n0,1\n1e-300,2\n", "too small to be written at an axis");
}

TEST_F(PlayArm, AnyPlaneIsFeltAlike) {
    const auto followed = [&](const char* plane) {
        const Ending ending = play({"--hand", "trace", "--json", "--plane", plane, "--arm", "phantom"});
        EXPECT_EQ(ending.code, 0) << ending.err;
        return number(ending.out, "curve_followed");
    };
    EXPECT_GT(followed("flat"), 0.9);
    EXPECT_GT(followed("0,1,1,10"), 0.9);
}

TEST_F(PlayArm, RefusesWhatDoesNotFit) {
    const auto told = [&](Words words, const char* what) {
        const Ending ending = play(std::move(words));
        EXPECT_EQ(ending.code, 1) << ending.err;
        EXPECT_TRUE(holds(ending.err, what)) << ending.err;
    };
    told({"--lever", "heavy"}, "--lever: it is about a mouse");
    told({"--arm", "omny"}, "there is no arm \"omny\" (omni?)");
    told({"--hand", "trase"}, "no hand is called \"trase\" (trace?)");
    told({"--feel", "grids"}, "a plot has no \"grids\" (grid?)");
    told({"--fixture", "r3"}, "no fixture is called \"r3\"");
    told({"--plane", "1,2"}, "it is upright, flat, or A,B,C,D");
    told({"--plane", "0,0,1,400"}, "leaves a field of less than 30 mm");
    told({"--stiffness", "5"}, "this comes to rest: --stiffness 0.");
    const Ending mouse = run_tactics(folder, {"play", "data.csv", "--arm", "omni"});
    EXPECT_EQ(mouse.code, 1);
    EXPECT_TRUE(holds(mouse.err, "--arm: it is about an arm")) << mouse.err;
}

TEST_F(PlayArm, ThreeHighestOfTenPoints) {
    std::string csv = "size,weight\n";
    const double heights[] = {2, 9.5, 4, 7, 1, 8.2, 3, 5, 9, 6};
    for (int i = 0; i < 10; ++i) csv += std::to_string(i + 1) + "," + std::to_string(heights[i]) + "\n";
    write_bytes(folder / "data.csv", csv);
    const Ending ending = play({"--hand", "points", "--points", "--json", "--seconds", "600"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(number(ending.out, "points_felt"), 10) << ending.out;
    EXPECT_EQ(number(ending.out, "highest_right"), 3) << ending.out;
}

// The hand presses a key when it has found something: what is under its finger at the curve, where it is at the end and at the
// tick.
TEST_F(PlayArm, SpeaksWhereTheHandIs) {
    const Ending ending = play({"--hand", "trace", "--speak", "recording:words.txt", "-q"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    const std::string words = bytes_of(folder / "words.txt");
    EXPECT_EQ(lines_in(words), 3u) << words;
    EXPECT_TRUE(holds(words, "curve")) << words;
    EXPECT_TRUE(holds(words, "time 5 s, speed ") || holds(words, "time 4.9")) << words;
    // Absent speech is a note, and never a failure.
    const Ending without = play({"--hand", "trace", "--speak", "tcp:127.0.0.1:1", "--json"});
    EXPECT_EQ(without.code, 0) << without.err;
}

TEST_F(PlayArm, SaysWhatShapeASurfaceHasByItsSections) {
    struct Shape {
        const char* name;
        double (*height)(double, double);
    };
    const Shape shapes[] = {{"hill", [](double x, double y) { return 2 - x * x - y * y; }},
                            {"bowl", [](double x, double y) { return x * x + y * y; }},
                            {"saddle", [](double x, double y) { return 1 + x * x - y * y; }},
                            {"ridge", [](double x, double) { return 1 - x * x; }},
                            {"slope", [](double x, double y) { return 2 + x + 0.2 * y; }}};
    for (const Shape& shape : shapes) {
        std::string csv = "x,y,z\n";
        for (int j = 0; j <= 20; ++j)
            for (int i = 0; i <= 20; ++i) {
                const double x = i / 10.0 - 1, y = j / 10.0 - 1;
                csv += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(shape.height(x, y)) + "\n";
            }
        write_bytes(folder / "data.csv", csv);
        const Ending ending = play({"--z", "z", "--hand", "sections", "--json", "--seconds", "120"});
        ASSERT_EQ(ending.code, 0) << ending.err;
        EXPECT_TRUE(holds(ending.out, std::string("\"shape_felt\":\"") + shape.name)) << shape.name << ending.out;
        EXPECT_TRUE(holds(ending.out, std::string("\"shape\":\"") + shape.name)) << shape.name << ending.out;
    }
}

}  // namespace
}  // namespace tactics::play_arm_test
