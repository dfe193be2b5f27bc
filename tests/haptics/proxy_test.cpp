// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/proxy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "tests/haptics/reliefs.h"

namespace tactics::proxy_test {
namespace {

static_assert(noexcept(std::declval<Proxy&>().follow({})));

double far(const Point3& a, const Point3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }
bool same(const Point3& a, const Point3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
std::string words(const Point3& p) { return std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z); }

// The facets once more, by weights of corners.
double facet_height(const HeightMap& map, double x, double y) {
    const double u = std::clamp(x / map.pitch - 0.5, 0.0, map.columns - 1.0),
                 v = std::clamp(y / map.pitch - 0.5, 0.0, map.rows - 1.0);
    const int i = std::min(static_cast<int>(u), std::max(map.columns - 2, 0)),
              j = std::min(static_cast<int>(v), std::max(map.rows - 2, 0));
    const int i1 = std::min(i + 1, map.columns - 1), j1 = std::min(j + 1, map.rows - 1);
    const double a = u - i, b = v - j, least = std::min(a, b), most = std::max(a, b);
    const float other = a >= b ? map.at(i1, j) : map.at(i, j1);
    return (1 - most) * static_cast<double>(map.at(i, j)) + (most - least) * static_cast<double>(other) +
           least * static_cast<double>(map.at(i1, j1));
}

// By how much (mm) a place right beside the proxy is nearer to the finger; 0 or less at a local minimum. So small a ring meets no
// facet that does not begin at the proxy, but for one place in a million.
constexpr double kGain = 1e-10;
double gain_nearby(const HeightMap& map, const Point3& proxy, const Point3& finger) {
    const double start = far(proxy, finger), radius = 1e-6 * map.pitch;
    double best = start;
    for (int way = 0; way < 32; ++way) {
        const double turn = way * std::acos(-1) / 16;
        const double x = proxy.x + radius * std::cos(turn), y = proxy.y + radius * std::sin(turn);
        best = std::min(best, far({x, y, std::max(finger.z, facet_height(map, x, y))}, finger));
    }
    return start - best;
}

// A finger on its way: strokes at the speed of a hand, and whatever else may come.
struct Hand {
    Hand(const ReliefSurface& felt, std::uint64_t seed) : surface(felt), random(seed), at{0, 0, felt.highest()}, goal(at) {}

    Point3 stroke(double step, double deep) {
        if (far(at, goal) < 2 * step) {
            const HeightMap& map = surface.map();
            const Point place{map.width() * (1.3 * random.uniform() - 0.15), map.height() * (1.3 * random.uniform() - 0.15)};
            goal = {place.x, place.y, surface.height(place) + deep * (2 * random.uniform() - 1)};
        }
        const double part = std::min(step / std::max(far(at, goal), 1e-9), 1.0);
        at = {at.x + (goal.x - at.x) * part, at.y + (goal.y - at.y) * part, at.z + (goal.z - at.z) * part};
        return at;
    }
    Point3 leap() {
        const HeightMap& map = surface.map();
        const double tall = surface.highest() - surface.lowest() + 1;
        at = {map.width() * (2 * random.uniform() - 0.5), map.height() * (2 * random.uniform() - 0.5),
              surface.lowest() + tall * (2.4 * random.uniform() - 1)};
        goal = at;
        return at;
    }

    const ReliefSurface& surface;
    RandomNumbers random;
    Point3 at, goal;
};

TEST(Proxy, IsNeverUnderTheSurfaceAndNeverLost) {
    int ticks = 0, unsettled = 0;
    for (const HardRelief& relief : hard_reliefs()) {
        const ReliefSurface surface(relief.map);
        Proxy proxy(surface);
        Hand hand(surface, seed_of(3, relief.map.heights.size()));
        Point3 before = proxy.follow(hand.leap());
        for (int i = 0; i < 90'000; ++i, ++ticks) {
            const bool leaps = (i / 1000) % 4 == 3;
            const Point3 finger = leaps ? hand.leap() : hand.stroke(i % 20'000 < 10'000 ? 0.1 : 0.4, 3);
            const Point3 now = proxy.follow(finger);
            ASSERT_GE(now.z, proxy.height({now.x, now.y})) << relief.name << " " << i;
            ASSERT_GE(now.z, facet_height(surface.map(), now.x, now.y) - 1e-9) << relief.name << " " << i;
            ASSERT_LE(far(now, finger), far(before, finger) + 1e-9) << relief.name << " " << i;
            if (finger.z >= surface.highest() && proxy.settled()) {
                ASSERT_TRUE(same(now, finger)) << relief.name << " " << i;
            }
            unsettled += proxy.settled() ? 0 : 1;
            if (proxy.settled() && i % 13 == 0) {
                ASSERT_LE(gain_nearby(surface.map(), now, finger), kGain)
                    << relief.name << " " << i << " finger " << words(finger) << " proxy " << words(now);
            }
            before = now;
        }
        // Taken off the map it is at the finger at last, wherever it was.
        const Point3 over{surface.map().width() / 3, -2, surface.highest() + 1};
        for (int i = 0; i < 20 && !same(proxy.follow(over), over); ++i) {
        }
        EXPECT_TRUE(same(proxy.follow(over), over)) << relief.name;
    }
    EXPECT_GE(ticks, 1'000'000);
    EXPECT_LT(unsettled, ticks / 10);
}

TEST(Proxy, IsAtTheFingerInAirOnHillsHoweverItGotThere) {
    const ReliefSurface surface(map_of(400, 300, 0.2, terrain));
    Proxy proxy(surface);
    Hand hand(surface, 11);
    int in_air = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Point3 finger = hand.stroke(0.1, 3), now = proxy.follow(finger);
        ASSERT_TRUE(proxy.settled());
        // The same finger again moves nothing: it was settled in the first tick.
        ASSERT_LE(far(proxy.follow(finger), now), 1e-9) << i;
        if (finger.z > facet_height(surface.map(), finger.x, finger.y)) {
            ++in_air;
            ASSERT_TRUE(same(now, finger)) << i << words(finger) << words(now);
        }
    }
    EXPECT_GT(in_air, 30'000);
}

// C. Ericson, Real-Time Collision Detection (2005), 5.1.5: the nearest place of a triangle, by its regions.
Point3 nearest_of_triangle(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
    const auto less = [](const Point3& s, const Point3& t) { return Point3{s.x - t.x, s.y - t.y, s.z - t.z}; };
    const auto dot = [](const Point3& s, const Point3& t) { return s.x * t.x + s.y * t.y + s.z * t.z; };
    const auto on = [](const Point3& s, const Point3& way, double t) {
        return Point3{s.x + way.x * t, s.y + way.y * t, s.z + way.z * t};
    };
    const Point3 ab = less(b, a), ac = less(c, a), ap = less(p, a), bp = less(p, b), cp = less(p, c);
    const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d1 <= 0 && d2 <= 0) return a;
    if (d3 >= 0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return on(a, ab, d1 / (d1 - d3));
    if (d6 >= 0 && d5 <= d6) return c;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return on(a, ac, d2 / (d2 - d6));
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return on(b, less(c, b), (d4 - d3) / ((d4 - d3) + (d5 - d6)));
    return on(on(a, ab, vb / (va + vb + vc)), ac, vc / (va + vb + vc));
}

Point3 nearest_of_all(const HeightMap& map, const Point3& finger) {
    Point3 best{};
    double least = std::numeric_limits<double>::infinity();
    const auto corner = [&](int column, int row) {
        return Point3{(column + 0.5) * map.pitch, (row + 0.5) * map.pitch, static_cast<double>(map.at(column, row))};
    };
    for (int row = 0; row + 1 < map.rows; ++row)
        for (int column = 0; column + 1 < map.columns; ++column)
            for (const Point3& third : {corner(column + 1, row), corner(column, row + 1)}) {
                const Point3 place = nearest_of_triangle(finger, corner(column, row), third, corner(column + 1, row + 1));
                if (far(place, finger) >= least) continue;
                least = far(place, finger);
                best = place;
            }
    return best;
}

// In a bowl every way down ends at the one nearest place. (A sum of a curve across and one down bends along no diagonal, so its
// facets are a bowl, too.)
TEST(Proxy, IsAtTheNearestPlaceOfABowl) {
    const HeightMap map = map_of(
        24, 20, 0.5, [](double x, double y) { return 0.25 * (x - 6) * (x - 6) + std::abs(y - 4) + 0.5 * std::max(y - 7, 0.0); });
    const ReliefSurface surface(map);
    Proxy proxy(surface);
    RandomNumbers random(8);
    for (int i = 0; i < 2000; ++i) {
        Point3 finger{1 + 10 * random.uniform(), 1 + 8 * random.uniform(), 0};
        finger.z = facet_height(map, finger.x, finger.y) - 6 * random.uniform();
        const Point3 now = proxy.follow(finger), nearest = nearest_of_all(map, finger);
        ASSERT_TRUE(proxy.settled());
        if (nearest.x < 0.3 || nearest.x > 11.7 || nearest.y < 0.3 || nearest.y > 9.7)
            continue;  // the twin ends at the edge of the map
        ASSERT_NEAR(far(now, finger), far(nearest, finger), 1e-6) << i;
        ASSERT_LE(far(now, nearest), 1e-3) << i << words(now)
                                           << words(nearest);  // the bowl is a float's breadth from flat along diagonals
    }
}

// The convex case: at a top the planes around it must not hold the proxy all together.
TEST(Proxy, SlidesOffATopToTheSideWhereTheFingerIs) {
    HeightMap map = map_of(9, 9, 1, [](double, double) { return 0; });
    map.at(4, 4) = 2;
    const ReliefSurface surface(map);
    for (int way = 0; way < 64; ++way) {
        const double turn = way * std::acos(-1) / 32;
        Proxy proxy(surface);
        proxy.follow({4.5, 4.5, 2.5});
        EXPECT_TRUE(same(proxy.follow({4.5, 4.5, 2}), {4.5, 4.5, 2}));
        const Point3 finger{4.5 + 0.6 * std::cos(turn), 4.5 + 0.6 * std::sin(turn), 0.2};
        const Point3 now = proxy.follow(finger);
        EXPECT_TRUE(proxy.settled());
        EXPECT_LE(gain_nearby(map, now, finger), kGain) << way;
        EXPECT_LT(now.z, 1.6) << way;
    }
}

TEST(Proxy, OnAFlatWallIsThereInTheFirstTickAndPullsStraightUp) {
    for (const double height : {0.0, 3.7, -11.3}) {
        const ReliefSurface surface(map_of(640, 480, 0.13, [&](double, double) { return height; }));
        Proxy proxy(surface);
        proxy.follow({5, 5, height + 0.01});
        for (int i = 0; i < 20'000; ++i) {
            const Point3 finger{5 + 0.1 * i / 40.7, 5 + 0.077 * i / 40.3, height - 2 - std::sin(0.01 * i)};
            const Point3 now = proxy.follow(finger);
            ASSERT_TRUE(proxy.settled());
            ASSERT_EQ(now.x, finger.x) << i;
            ASSERT_EQ(now.y, finger.y) << i;
            ASSERT_NEAR(now.z, height, 1e-6);
        }
    }
}

TEST(Proxy, InACornerOfThreeFacetsIsThereInTheFirstTick) {
    // Two walls of 45 degrees and a floor meet at (10, 10, 0).
    const auto corner = [](double x, double y) { return std::max({0.0, x - 10, y - 10}); };
    const ReliefSurface surface(map_of(40, 40, 0.5, [&](double x, double y) { return corner(x + 0.25, y + 0.25); }));
    Proxy proxy(surface);
    proxy.follow({8, 8, 1});
    const Point3 finger{10.4, 10.4, -1.5}, now = proxy.follow(finger);
    EXPECT_TRUE(proxy.settled());
    EXPECT_NEAR(now.x, 9.75, 1e-12);
    EXPECT_NEAR(now.y, 9.75, 1e-12);
    EXPECT_NEAR(now.z, 0, 1e-12);
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(same(proxy.follow(finger), now));
}

TEST(Proxy, GoesStraightThroughAir) {
    const ReliefSurface surface(map_of(60, 20, 0.5, [](double x, double) { return x > 10 && x < 12 ? 5 : 0; }));
    Proxy proxy(surface);
    const Point3 over{25, 5, 1};
    proxy.follow({5, 5, 9});
    EXPECT_TRUE(same(proxy.follow(over), over));  // 6 mm high where the wall is
    proxy.follow({5, 5, 9});
    proxy.follow({5, 5, 1});
    EXPECT_LT(proxy.follow(over).x, 10.5);
}

TEST(Proxy, GoesOnWithAWayThatWasTooLongForOneTick) {
    const ReliefSurface surface(map_of(3000, 40, 0.1, [](double x, double) { return 0.3 * std::sin(x); }));
    Proxy proxy(surface);
    Point3 before = proxy.follow({2, 2, 0});
    const Point3 finger{290, 1.7, -5};
    int ticks = 0;
    do {
        const Point3 now = proxy.follow(finger);
        ASSERT_GE(now.z, proxy.height({now.x, now.y}));
        ASSERT_LT(far(now, finger), far(before, finger));
        before = now;
        ++ticks;
    } while (!proxy.settled() && ticks < 1000);
    EXPECT_TRUE(proxy.settled());
    EXPECT_GT(ticks, 3);
    EXPECT_LE(gain_nearby(surface.map(), before, finger), kGain);
}

TEST(Proxy, BearsFingersThatAreNowhereOrFarAway) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kEndless = std::numeric_limits<double>::infinity();
    for (const HardRelief& relief : hard_reliefs()) {
        const ReliefSurface surface(relief.map);
        Proxy proxy(surface);
        EXPECT_TRUE(std::isfinite(proxy.follow({kNan, 0, 0}).z));
        const Point3 first = proxy.follow({0.3, 0.3, surface.lowest() - 1});
        for (const Point3& finger : {Point3{kNan, 1, 1}, Point3{1, -kEndless, 1}, Point3{1, 1, kEndless}})
            EXPECT_TRUE(same(proxy.follow(finger), first));
        for (const double away : {-1e300, -1e12, -1e4, 1e4, 1e300})
            for (const Point3& finger : {Point3{away, 1, 1}, Point3{1, away, 1}, Point3{1, 1, away}, Point3{away, away, away}}) {
                const Point3 now = proxy.follow(finger);
                ASSERT_TRUE(std::isfinite(now.x) && std::isfinite(now.y)) << relief.name;
                ASSERT_GE(now.z, proxy.height({now.x, now.y})) << relief.name;
            }
    }
}

TEST(Proxy, BesideTheMapFollowsAnyFar) {
    const ReliefSurface surface(map_of(20, 20, 0.5, [](double, double) { return 1; }));
    Proxy proxy(surface);
    proxy.follow({5, 5, 2});
    const Point3 now = proxy.follow({5000, 5, -1});
    EXPECT_EQ(now.x, 5000);
    EXPECT_EQ(now.y, 5);
    EXPECT_NEAR(now.z, 1, 1e-12);
}

TEST(Proxy, LiftedBeginsAboveTheFinger) {
    const ReliefSurface surface(map_of(60, 20, 0.5, [](double x, double) { return x > 14 && x < 16 ? 20 : 0; }));
    Proxy proxy(surface);
    proxy.follow({5, 5, 1});
    const Point3 behind{25, 5, 1};
    EXPECT_LT(proxy.follow(behind).x, 15);  // the wall holds it
    proxy.lift();
    EXPECT_TRUE(same(proxy.follow(behind), behind));
}

}  // namespace
}  // namespace tactics::proxy_test
