// SPDX-License-Identifier: Apache-2.0
// Shapes of surfaces by two sections: from numbers, and through `tactics play` with a hand that feels them.
#include "cli/verbs/felt_shape.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "tests/cli/converting.h"

namespace tactics::felt_shape_test {
namespace {

using namespace tests;

Section section_of(const std::function<double(double)>& height) {
    Section section;
    for (int i = 0; i <= 200; ++i)
        if (const double y = height(i / 200.0); std::isfinite(y))
            section.heights.push_back({i / 200.0, y});
        else
            section.bare.push_back(i / 200.0);
    return section;
}

TEST(FeltShape, CoursesOfKnownSections) {
    const struct {
        const char* course;
        double (*height)(double);
    } kKnown[] = {{"level", [](double) { return 3.0; }},
                  {"level", [](double x) { return 0.04 * std::sin(20 * x); }},
                  {"slope", [](double x) { return 2 * x; }},
                  {"slope", [](double x) { return std::exp(3 * x) / 20; }},
                  {"slope", [](double x) { return 2 * x + 0.1 * std::sin(30 * x); }},
                  {"slope", [](double x) { return -(x - 1.1) * (x - 1.1); }},
                  {"step", [](double x) { return x < 0.7 ? 0.0 : 1.0; }},
                  {"step", [](double x) { return std::atan(30 * (x - 0.4)) / 3; }},
                  {"step", [](double x) { return (x < 0.6 ? 0.0 : 1.0) + 0.4 * x; }},
                  {"steps", [](double x) { return (x < 0.3 ? 0.0 : 1.0) + (x < 0.65 ? 0.0 : 1.6); }},
                  {"steps", [](double x) { return std::floor(4 * x + 0.1) / 3; }},
                  {"steps", [](double x) { return (x < 0.3 ? 0.0 : 0.2) + (x < 0.6 ? 0.0 : 0.8); }},
                  {"steps", [](double x) { return std::floor(4.99 * x) / 4; }},
                  {"step", [](double x) { return 1 / (1 + std::exp(-17 * (x - 0.5))); }},
                  {"slope", [](double x) { return 1 / (1 + std::exp(-10 * (x - 0.5))); }},
                  {"step", [](double x) { return std::clamp((x - 0.35) / 0.3, 0.0, 1.0); }},
                  {"slope", [](double x) { return std::clamp((x - 0.27) / 0.46, 0.0, 1.0); }},
                  {"waves", [](double x) { return std::sin(80 * x); }},
                  {"hump", [](double x) { return x > 0.45 && x < 0.46 ? 1.0 : 0.0; }},
                  {"hump", [](double x) { return -std::abs(x - 0.5); }},
                  {"hump", [](double x) { return std::exp(-30 * (x - 0.7) * (x - 0.7)); }},
                  {"hump", [](double x) { return x > 0.45 && x < 0.5 ? 1.0 : 0.0; }},
                  {"dip", [](double x) { return std::pow(2 * x - 1, 4); }},
                  {"waves", [](double x) { return std::sin(12 * x); }},
                  {"hole", [](double x) { return x > 0.3 && x < 0.35 ? NAN : x; }}};
    for (const auto& [course, height] : kKnown) {
        EXPECT_EQ(course_of(section_of(height), 1), course);
        // From the other side, higher up, and as large in all.
        EXPECT_EQ(course_of(section_of([h = height](double x) { return h(1 - x); }), 1), course);
        EXPECT_EQ(course_of(section_of([h = height](double x) { return 7 + 20 * h(x); }), 20), course);
        // Upside down a hump is a dip.
        const std::string_view turned = course_of(section_of([h = height](double x) { return -h(x); }), 1);
        EXPECT_EQ(turned == "hump" ? "dip" : turned == "dip" ? "hump" : turned, course);
    }
}

// However narrow it is, half of a hill that a border cuts off at its top or before it is smooth, and so is what becomes ever
// steeper; between level grounds the same rise is a step where it is narrow enough.
TEST(FeltShape, HalfAHillIsNoStep) {
    for (const double width : {0.07, 0.1, 0.14, 0.2, 0.3, 0.5}) {
        for (const double top : {0.9, 0.95, 1.0, 1.1}) {
            const auto hill = [&](double x) { return std::exp(-(x - top) * (x - top) / (2 * width * width)); };
            EXPECT_EQ(course_of(section_of(hill), hill(0.9)), "slope") << width << " " << top;
            EXPECT_EQ(course_of(section_of([&](double x) { return hill(1 - x); }), hill(0.9)), "slope") << width << " " << top;
        }
        const auto ever_steeper = [&](double x) { return std::exp((x - 1) / width); };
        EXPECT_EQ(course_of(section_of(ever_steeper), ever_steeper(0.9)), "slope") << width;
        const auto between = [&](double x) { return std::tanh((x - 0.5) / width); };
        EXPECT_EQ(course_of(section_of(between), 2), width < 0.12 ? "step" : "slope") << width;
    }
}

// As rough as 3 % of all heights, in places a sixtieth of the section apart.
TEST(FeltShape, RoughnessChangesNoCourse) {
    const struct {
        const char* course;
        double (*height)(double);
    } kSmooth[] = {{"slope", [](double x) { return x; }},
                   {"step", [](double x) { return x < 0.43 ? 0.0 : 1.0; }},
                   {"steps", [](double x) { return std::floor(2.99 * x) / 2; }},
                   {"steps", [](double x) { return (x < 0.36 ? 0.0 : 0.3) + (x < 0.6 ? 0.0 : 0.7); }},
                   {"hump", [](double x) { return std::exp(-30 * (x - 0.4) * (x - 0.4)); }},
                   {"dip", [](double x) { return 4 * (x - 0.5) * (x - 0.5); }},
                   {"waves", [](double x) { return 0.5 + 0.5 * std::sin(25 * x); }}};
    std::mt19937 random(5);
    std::normal_distribution<double> off(0, 0.03);
    for (const auto& [course, height] : kSmooth)
        for (int round = 0; round < 10; ++round) {
            std::vector<double> rough(62);
            for (double& one : rough) one = off(random);
            const auto felt = [&rough, h = height](double x) {
                const auto place = static_cast<std::size_t>(60 * x);
                const double share = 60 * x - static_cast<double>(place);
                return h(x) + (1 - share) * rough[place] + share * rough[place + 1];
            };
            EXPECT_EQ(course_of(section_of(felt), 1), course) << round;
        }
}

// What nobody has felt is no height of 0.
TEST(FeltShape, AMissingStretchIsUnknown) {
    for (const double missing : {0.1, 0.4, 0.75}) {
        Section section;
        for (int i = 0; i <= 200; ++i)
            if (const double x = i / 200.0; x < missing || x > missing + 0.2) section.heights.push_back({x, 5 + x});
        EXPECT_EQ(course_of(section, 10), "") << missing;
    }
    EXPECT_EQ(course_of({}, 10), "");
    EXPECT_EQ(shape_of("", "hump"), "");
}

TEST(FeltShape, EitherSectionMayBeTheOneAcross) {
    const char* const kCourses[] = {"level", "slope", "step", "steps", "hump", "dip", "waves", "hole", ""};
    for (const char* a : kCourses)
        for (const char* b : kCourses) EXPECT_EQ(shape_of(a, b), shape_of(b, a)) << a << b;
    EXPECT_EQ(shape_of("hump", "dip"), "saddle");
    EXPECT_EQ(shape_of("slope", "dip"), "valley");
    EXPECT_EQ(shape_of("waves", "hump"), "");  // two hills
    EXPECT_EQ(shape_of("steps", "level"), "steps");
    EXPECT_EQ(shape_of("steps", "step"), "");
}

class FeltSections : public Convert {
protected:
    Ending feel(const std::function<double(double, double)>& height, Words words) {
        std::string csv = "x,y,z\n";
        for (int j = 0; j <= 24; ++j)
            for (int i = 0; i <= 24; ++i) {
                const double x = i / 12.0 - 1, y = j / 12.0 - 1, z = height(x, y);
                csv += std::to_string(x) + "," + std::to_string(y) + "," + (std::isfinite(z) ? std::to_string(z) : "") + "\n";
            }
        write_bytes(folder / "data.csv", csv);
        words.insert(words.begin(), {"play", "data.csv", "--z", "z", "--device", "arm", "--hand", "sections"});
        return run_tactics(folder, words);
    }
};

// Where the finger slides aside, flies off an edge, has to climb, or finds no ground; with noise and delay.
TEST_F(FeltSections, AHandTellsShapesThatItGetsThrough) {
    const struct {
        const char* shape;
        double (*height)(double, double);
    } kSurfaces[] = {
        {"hill", [](double x, double y) { return -std::hypot(x, y); }},
        {"bowl", [](double x, double y) { return std::pow(x, 4) + std::pow(y, 4); }},
        {"step", [](double x, double) { return x > 0 ? 1.0 : 0.0; }},
        {"steps", [](double, double y) { return (y > -0.4 ? 1.0 : 0.0) + (y > 0.3 ? 1.5 : 0.0); }},
        {"slope", [](double x, double) { return std::exp(-6 * (x - 0.95) * (x - 0.95)); }},
        {"waves", [](double, double y) { return std::sin(9 * y); }},
        {"steps", [](double x, double) { return (x > -0.4 ? 0.3 : 0.0) + (x > 0.25 ? 0.7 : 0.0); }},
        {"step", [](double x, double) { return 1 / (1 + std::exp(-12 * x)); }},
        {"slope", [](double x, double) { return std::exp(x); }},
        {"level", [](double x, double y) { return x > 0.95 && y > 0.95 ? 1.0 : 0.0; }},
        {"hole", [](double x, double y) { return std::hypot(x - 0.2, y) < 0.25 ? NAN : x * x; }},
    };
    write_bytes(folder / "noisy.txt", "arm = phantom\narm.noise = 0.05 mm\narm.delay = 0.002 s\n");
    for (const auto& surface : kSurfaces)
        for (const char* arm : {"omni", "noisy.txt"}) {
            const Ending ending = feel(surface.height, {"--arm", arm, "--json", "--seconds", "120"});
            ASSERT_EQ(ending.code, 0) << ending.err;
            EXPECT_TRUE(holds(ending.out, std::string("\"shape_felt\":\"") + surface.shape))
                << surface.shape << arm << ending.out;
            EXPECT_TRUE(holds(ending.out, std::string("\"shape\":\"") + surface.shape)) << surface.shape << arm << ending.out;
            EXPECT_TRUE(holds(ending.out, "\"hand_ended\":true")) << surface.shape << arm;
        }
}

TEST_F(FeltSections, SaysWhatItHasNotFelt) {
    const auto hills = [](double x, double y) {
        return std::exp(-10 * ((x - 0.5) * (x - 0.5) + y * y)) + std::exp(-10 * ((x + 0.5) * (x + 0.5) + y * y));
    };
    const Ending two = feel(hills, {"--seconds", "120"});
    EXPECT_TRUE(holds(two.err, "its two sections are those of waves across and a hump down, as they are")) << two.err;
    const Ending json = feel(hills, {"--seconds", "120", "--json"});
    EXPECT_TRUE(holds(json.out, R"("section_across":"waves","section_down":"hump")")) << json.out;
    EXPECT_FALSE(holds(json.out, "\"shape")) << json.out;
    const Ending late = feel(hills, {"--seconds", "3"});
    EXPECT_TRUE(holds(late.err, "the hand did not feel the whole of its two sections")) << late.err;
    EXPECT_TRUE(holds(late.err, "the hand was still under way when the seconds ended")) << late.err;
    EXPECT_TRUE(holds(feel(hills, {"--seconds", "3", "--json"}).out, "\"hand_ended\":false"));
}

}  // namespace
}  // namespace tactics::felt_shape_test
