// SPDX-License-Identifier: Apache-2.0
// `tactics play` of height maps, pictures and models on a simulated arm, through the program.
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "tests/cli/converting.h"
#include "tests/cli/tick_rows.h"

namespace tactics::play_relief_on_arm_test {
namespace {

using namespace tests;

struct Tick {
    double time, x, y, finger, surface, reference, up, right, down;
    double force() const { return std::hypot(up, right, down); }
};

std::vector<Tick> ticks_in(const std::string& csv) {
    std::vector<Tick> ticks;
    for (const auto& v : tick_rows(csv))
        ticks.push_back({v.at(0), v.at(1), v.at(2), v.at(3), v.at(4), v.at(5), v.at(6), v.at(7), v.at(8)});
    return ticks;
}

// N mm that the finger has got from the motors at most, at any time since it was in the air.
double most_work(const std::vector<Tick>& ticks) {
    double work = 0, most = 0;
    for (std::size_t i = 0; i + 1 < ticks.size(); ++i) {
        const Tick &a = ticks[i], &b = ticks[i + 1];
        work += a.right * (b.x - a.x) + a.down * (b.y - a.y) + a.up * (b.finger - a.finger);
        most = std::max(most, work);
    }
    return most;
}

// A ball of 30 mm, closed, facets outwards.
std::string ball() {
    constexpr int kRound = 48, kDown = 24;
    const auto place = [](int i, int j) {
        const double a = 2 * std::numbers::pi * (i % kRound) / kRound, b = std::numbers::pi * j / kDown;
        const double r = j == 0 || j == kDown ? 0 : 30 * std::sin(b);
        char text[100];
        std::snprintf(text, sizeof text, "vertex %.3f %.3f %.3f\n", r * std::cos(a) + 0.0, r * std::sin(a) + 0.0,
                      30 * std::cos(b));
        return std::string(text);
    };
    std::string stl = "solid ball\n";
    const auto facet = [&](const std::string& a, const std::string& b, const std::string& c) {
        stl += "facet normal 0 0 0\nouter loop\n" + a + b + c + "endloop\nendfacet\n";
    };
    for (int j = 0; j < kDown; ++j)
        for (int i = 0; i < kRound; ++i) {
            if (j > 0) facet(place(i, j), place(i, j + 1), place(i + 1, j));
            if (j + 1 < kDown) facet(place(i + 1, j), place(i, j + 1), place(i + 1, j + 1));
        }
    return stl + "endsolid ball\n";
}

class PlayReliefOnArm : public Convert {
protected:
    Ending play(Words words) {
        words.insert(words.begin(), "play");
        words.insert(words.end(), {"--device", "arm"});
        return run_tactics(folder, words);
    }
    std::vector<Tick> ticks_of(Words words) {
        words.insert(words.end(), {"--csv", "ticks.csv", "-q"});
        const Ending ending = play(std::move(words));
        EXPECT_EQ(ending.code, 0) << ending.err;
        return ticks_in(bytes_of(folder / "ticks.csv"));
    }
};

// It is drawn for the arm's own workspace, and a hand that presses on it goes over its lines.
TEST_F(PlayReliefOnArm, APicturesLinesAreFeltAndGiveNoEnergy) {
    const std::vector<Tick> ticks = ticks_of({"disc.tif", "--recipe", "photo", "--seconds", "20"});
    ASSERT_EQ(ticks.size(), 20'000u);
    double highest = 0, least = 1000, most = 0;
    for (const Tick& tick : ticks) {
        EXPECT_LE(tick.force(), 3.3 + 1e-3);
        highest = std::max(highest, tick.surface);
        least = std::min(least, tick.x);
        most = std::max(most, tick.x);
    }
    EXPECT_NEAR(highest, 0.5, 0.02);
    EXPECT_GT(most - least, 50);
    EXPECT_LT(most_work(ticks), 0.05);
    EXPECT_EQ(ticks_of({"disc.tif", "--recipe", "photo", "--seconds", "20"}).size(), ticks.size());
}

// A level map pushes upwards only, however the finger slides.
TEST_F(PlayReliefOnArm, ALevelMapPushesStraightUp) {
    std::string pgm = "P5 40 30 255\n" + std::string(1200, '\x80');
    write_bytes(folder / "level.pgm", pgm);
    std::size_t touched = 0;
    for (const Tick& tick : ticks_of({"level.pgm", "--pitch", "2mm", "--low", "0", "--high", "5mm", "--seconds", "5"})) {
        ASSERT_EQ(tick.right, 0);
        ASSERT_EQ(tick.down, 0);
        touched += tick.up > 0 ? 1 : 0;
    }
    EXPECT_GT(touched, 3000u);
}

TEST_F(PlayReliefOnArm, AMapThatIsLargerThanTheWorkspaceIsFeltSmallerAndTold) {
    std::string pgm = "P5 100 100 255\n";
    for (int i = 0; i < 10'000; ++i) pgm += static_cast<char>(i % 100 * 255 / 99);
    write_bytes(folder / "ramp.pgm", pgm);
    const Words words = {"ramp.pgm", "--width", "300mm", "--low", "2mm", "--high", "14mm", "--seconds", "4"};
    const Ending told = play(words);
    ASSERT_EQ(told.code, 0) << told.err;
    // The Omni has 160 x 120 x 70 mm, 8 mm of which it keeps round what is felt; upright that is more than flat.
    EXPECT_TRUE(holds(told.err, "it is 300 x 300 x 12 mm, and is felt 0.347 times as large: 104 x 104 x 4.16 mm")) << told.err;
    double highest = 0;
    for (const Tick& tick : ticks_of(words)) highest = std::max(highest, tick.surface);
    EXPECT_GT(highest, 0.85 * 4.16);
    EXPECT_LE(highest, 4.17);
    // What fits is as large as it is.
    EXPECT_FALSE(holds(play({"ramp.pgm", "--width", "50mm", "--high", "8mm", "--seconds", "1"}).err, "times as large"));
}

// Finer than a fingertip can tell, a map is made coarser, by its tops, before its radius is reckoned with.
TEST_F(PlayReliefOnArm, AFineMapKeepsItsTops) {
    std::string pgm = "P5 3000 1000 255\n" + std::string(3'000'000, '\0');
    for (int row = 0; row < 1000; ++row) pgm[pgm.size() - 3'000'000 + static_cast<std::size_t>(row) * 3000 + 1500] = '\xff';
    write_bytes(folder / "ridge.pgm", pgm);
    const Words words = {"ridge.pgm", "--pitch", "0.03mm", "--low", "0", "--high", "3mm", "--seconds", "6"};
    double highest = 0;
    for (const Tick& tick : ticks_of(words)) highest = std::max(highest, tick.surface);
    EXPECT_NEAR(highest, 3, 0.1);
    // A point has the map as it is.
    Words point = words;
    point.insert(point.end(), {"--radius", "0mm"});
    EXPECT_EQ(play(point).code, 0);
}

// From the left, from below and from above: no height map has the second.
TEST_F(PlayReliefOnArm, AModelIsFeltFromAllSides) {
    write_bytes(folder / "ball.stl", ball());
    const auto pushed = [&](const char* way) {
        write_bytes(folder / "way.csv", way);
        const Ending ending = run_tactics(folder, {"play", "ball.stl", "--device", "recorded:way.csv", "--arm", "omni", "--width",
                                                   "50mm", "--csv", "ticks.csv", "-q"});
        EXPECT_EQ(ending.code, 0) << ending.err;
        return ticks_in(bytes_of(folder / "ticks.csv")).back();
    };
    const Tick left = pushed("time_s,x_mm,y_mm,z_mm\n0,-10,25,25\n1,0.6,25,25\n2,0.6,25,25\n");
    EXPECT_LT(left.right, -0.3);
    EXPECT_NEAR(std::hypot(left.up, left.down), 0, 0.05);
    const Tick below = pushed("time_s,x_mm,y_mm,z_mm\n0,25,25,-10\n1,25,25,0.6\n2,25,25,0.6\n");
    EXPECT_LT(below.up, -0.3);
    const Tick above = pushed("time_s,x_mm,y_mm,z_mm\n0,25,25,60\n1,25,25,49.4\n2,25,25,49.4\n");
    EXPECT_GT(above.up, 0.3);
    const Ending hand = play({"ball.stl", "--hand", "sections", "--json"});
    EXPECT_TRUE(holds(hand.out, "\"shape_felt\":\"hill\"")) << hand.out << hand.err;
}

// Lines of equal height and sections are curves, which a hand finds and a voice names.
TEST_F(PlayReliefOnArm, ASurfaceIsFeltByItsLinesOfEqualHeightOrCutOpen) {
    std::string csv = "east (km),north (km),height (m)\n";
    for (int j = 0; j <= 20; ++j)
        for (int i = 0; i <= 20; ++i) {
            const double x = i / 10.0 - 1, y = j / 10.0 - 1;
            csv += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(100 - 50 * (x * x + y * y)) + "\n";
        }
    write_bytes(folder / "hill.csv", csv);
    const auto traced = [&](Words words) {
        std::filesystem::remove(folder / "words.txt");
        words.insert(words.begin(), {"hill.csv", "--z", "height"});
        words.insert(words.end(), {"--hand", "trace", "--speak", "recording:words.txt"});
        const Ending ending = play(std::move(words));
        EXPECT_EQ(ending.code, 0) << ending.err;
        return ending.err + bytes_of(folder / "words.txt");
    };
    const std::string levels = traced({"--levels", "5"});
    EXPECT_TRUE(holds(levels, "felt as lines of equal height: height = 20 m, height = 40 m, height = 60 m, height = 80 m"))
        << levels;
    EXPECT_TRUE(holds(levels, "curve height = ")) << levels;
    EXPECT_TRUE(holds(levels, "and followed")) << levels;
    const std::string section = traced({"--section", "y=0.5"});
    EXPECT_TRUE(holds(section, "felt cut open: north = 0.5 km")) << section;
    EXPECT_TRUE(holds(section, "curve north = 0.5 km")) << section;
    // From 37.5 to 87.5 and back: its values are heights now.
    EXPECT_TRUE(holds(section, "height ")) << section;
    EXPECT_TRUE(holds(traced({"--levels", "auto"}), "felt as lines of equal height"));
    // A map of heights has them, too.
    std::string pgm = "P5 100 100 255\n";
    for (int i = 0; i < 10'000; ++i) pgm += static_cast<char>(i % 100 * 255 / 99);
    write_bytes(folder / "ramp.pgm", pgm);
    const Ending map = play({"ramp.pgm", "--width", "100mm", "--high", "10mm", "--levels", "4", "--seconds", "1"});
    EXPECT_TRUE(holds(map.err, "height = 2 mm, height = 4 mm, height = 6 mm, height = 8 mm")) << map.err;
}

TEST_F(PlayReliefOnArm, IsDrawnFromTheFrontAndFromAboveWithinTheRules) {
    write_bytes(folder / "ball.stl", ball());
    write_bytes(folder / "data.csv", "t,v\n0,1\n1,3\n2,2\n3,5\n");
    // Without a depth, and without a width.
    for (const auto& [name, corner] : {std::pair("gable.stl", "20 0 30"), std::pair("door.stl", "0 20 30")})
        write_bytes(folder / name, std::string("solid sheet\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex ") +
                                       (corner[0] == '0' ? "0 40 0" : "40 0 0") + "\nvertex " + corner +
                                       "\nendloop\nendfacet\nendsolid sheet\n");
    for (const char* what : {"ball.stl", "data.csv", "disc.tif", "gable.stl", "door.stl"}) {
        const Ending ending = play({what, "--seconds", "5", "--plot", "way.svg", "--plot", "way.pdf", "-q"});
        ASSERT_EQ(ending.code, 0) << what << ending.err;
        EXPECT_EQ(run_tactics(folder, {"check", "way.svg", "way-2.svg"}).code, 0) << what;
        const std::string front = bytes_of(folder / "way.svg"), above = bytes_of(folder / "way-2.svg");
        EXPECT_TRUE(holds(front, "from the front")) << what;
        EXPECT_TRUE(holds(above, "from above")) << what;
        EXPECT_TRUE(holds(above, "way of the finger")) << what;
        EXPECT_TRUE(holds(bytes_of(folder / "way.pdf"), "/Count 2")) << what;
        const bool is_sheet = std::string_view(what) == "gable.stl" || std::string_view(what) == "door.stl";
        EXPECT_TRUE(!is_sheet || (holds(front, ">outline<") && holds(above, ">outline<"))) << what;
    }
    std::filesystem::remove(folder / "way-2.svg");
    ASSERT_EQ(play({"data.csv", "--seconds", "2", "--view", "above", "--plot", "way.svg", "-q"}).code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "way-2.svg"));
    EXPECT_TRUE(holds(bytes_of(folder / "way.svg"), "from above"));
}

// x to the right, y away from the person, z upwards: a corner whose one edge is upright at the left and near the person.
TEST_F(PlayReliefOnArm, AModelIsNotMirrored) {
    std::string stl = "solid corner\n";
    const char *o = "vertex 0 0 0\n", *x = "vertex 40 0 0\n", *y = "vertex 0 30 0\n", *z = "vertex 0 0 20\n";
    for (const auto& [a, b, c] : {std::tuple(o, y, x), std::tuple(o, x, z), std::tuple(o, z, y), std::tuple(x, y, z)})
        stl += std::string("facet normal 0 0 0\nouter loop\n") + a + b + c + "endloop\nendfacet\n";
    write_bytes(folder / "corner.stl", stl + "endsolid corner\n");
    const auto up = [&](const std::string& place) {
        write_bytes(folder / "way.csv", "time_s,x_mm,y_mm,z_mm\n0," + place + ",30\n1," + place + ",15\n2," + place + ",15\n");
        const Ending ending = run_tactics(folder, {"play", "corner.stl", "--device", "recorded:way.csv", "--arm", "omni",
                                                   "--width", "40mm", "--csv", "ticks.csv", "-q"});
        EXPECT_EQ(ending.code, 0) << ending.err;
        return ticks_in(bytes_of(folder / "ticks.csv")).back().up;
    };
    EXPECT_GT(up("2,28"), 0.3);  // 1.7 mm under the slope
    EXPECT_EQ(up("2,2"), 0);
    EXPECT_EQ(up("38,28"), 0);
}

TEST_F(PlayReliefOnArm, RefusesWhatDoesNotFit) {
    write_bytes(folder / "ball.stl", ball());
    write_bytes(folder / "data.csv", "t,v\n0,1\n1,3\n2,2\n3,5\n");
    const auto told = [&](Words words, const char* what) {
        const Ending ending = play(std::move(words));
        EXPECT_EQ(ending.code, 1) << ending.err;
        EXPECT_TRUE(holds(ending.err, what)) << ending.err;
    };
    told({"ball.stl", "--pitch", "1mm"}, "--pitch: a model is felt on an arm as it is");
    told({"data.csv", "--recipe", "photo"}, "--recipe: it is about maps, and a table is felt on an arm as its plot");
    told({"data.csv", "--radius", "2mm"}, "--radius: it is about maps and models");
    told({"disc.tif", "--points"}, "--points: it is about the plot of a table, and disc.tif is none");
    told({"disc.tif", "--feel", "wall"}, "--feel: it is about a plot");
    told({"disc.tif", "--hand", "trace"}, "--hand: a relief and a model have no curves and no points");
    told({"disc.tif", "--wall", "raw"}, "--wall: it is about a mouse");
    told({"disc.tif", "--plane", "0,0,1,58"}, "--plane: the plane leaves");
    told({"ball.stl", "--plane", "0,1,0,52"}, "--plane: the plane leaves less than 10 mm");
    told({"disc.tif", "--width", "100mm", "--high", "4m"}, "--plane: so high a map leaves less than 30 mm of its sides");
    told({"disc.tif", "--paper", "a4"}, "--paper: it is about a drawing");
    told({"disc.tif", "--csv", "./disc.tif"}, "./disc.tif would be written over, and it is read");
    told({"data.csv", "--levels", "5"}, "--levels: it is about a surface, and data.csv has none");
    told({"data.csv", "--levels", "5", "--section", "y=1"}, "--section: contours and sections do not share axes");
    told({"disc.tif", "--recipe", "photo", "--levels", "5"}, "--levels: disc.tif is drawn as lines, which are no surface");
    told({"data.csv", "--view", "above"}, "--view: it is of the drawing of --plot");
    told({"data.csv", "--view", "abov", "--plot", "a.svg"}, "--view: it cannot be \"abov\" (above?)");
    told({"data.csv", "--plot", "svg:-"}, "there are 2 pages, and svg holds one");
    write_bytes(folder / "way-2.svg", "t,v\n0,1\n1,3\n");
    told({"way-2.svg", "--plot", "way.svg"}, "way-2.svg would be written over, and it is read");
    told({}, "name one table, picture, height map or model");
    const Ending nothing = play({"missing.stl"});
    EXPECT_EQ(nothing.code, 2);
    write_bytes(folder / "cut.stl", "solid cut\nfacet normal 0 0 0\n");
    EXPECT_EQ(play({"cut.stl"}).code, 2);
}

TEST_F(PlayReliefOnArm, OfHeightsItsLeastLossIsFeltIfAsked) {
    std::string hills = "P5 200 120 255\n";
    for (int i = 0; i < 200 * 120; ++i)
        hills += static_cast<char>(static_cast<int>(100 + 90 * std::sin(i % 200 / 9.0) * std::sin(i / 200 / 7.0)));
    write_bytes(folder / "hills.pgm", hills);
    write_bytes(folder / "plot.csv", "x,y\n0,1\n1,2\n2,4\n");
    const Ending best = play({"hills.pgm", "--width", "100mm", "--high", "10mm", "--best", "--seconds", "1"});
    EXPECT_EQ(best.code, 0) << best.err;
    EXPECT_TRUE(holds(best.err, "hills.pgm: for omni: ")) << best.err;
    EXPECT_TRUE(
        holds(play({"hills.pgm", "--width", "100mm", "--best", "--seconds", "1", "--arm", "desktop"}).err, "for desktop: "));
    const Ending plot = play({"plot.csv", "--best"});
    EXPECT_EQ(plot.code, 1);
    EXPECT_TRUE(holds(plot.err, "--best: it is about maps")) << plot.err;
    const Ending mouse = run_tactics(folder, {"play", "hills.pgm", "--high", "10mm", "--best", "--seconds", "1"});
    EXPECT_TRUE(holds(mouse.err, "for mouse: ")) << mouse.err;
}

}  // namespace
}  // namespace tactics::play_relief_on_arm_test
