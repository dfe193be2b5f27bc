// SPDX-License-Identifier: Apache-2.0
// Contours against the samples that they part, and against a naive twin in exact fractions.
#include "filters/contour_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

namespace tactics::contour_lines_test {
namespace {

PlotSurface random_surface(std::mt19937& random, std::size_t columns, std::size_t rows, unsigned unknown) {
    PlotSurface surface;
    for (std::size_t i = 0; i < columns; ++i) surface.x.push_back(static_cast<double>(i));
    for (std::size_t i = 0; i < rows; ++i) surface.y.push_back(static_cast<double>(i));
    for (std::size_t i = 0; i < columns * rows; ++i)
        surface.z.push_back(random() % 100 < unknown ? NAN : static_cast<double>(random() % 9));
    return surface;
}

struct Fraction {
    std::int64_t top = 0, bottom = 1;
    auto reduced() const {
        const std::int64_t common = std::gcd(top, bottom);
        return std::pair(top / common, bottom / common);
    }
    bool operator<(const Fraction& other) const { return reduced() < other.reduced(); }
    double value() const { return static_cast<double>(top) / static_cast<double>(bottom); }
};
using Place = std::pair<Fraction, Fraction>;

// Cell by cell: where each side is crossed, and which crossings belong together. Heights are whole numbers, twice the level is
// odd.
std::vector<std::pair<Place, Place>> twin(const PlotSurface& surface, int twice) {
    std::vector<std::pair<Place, Place>> all;
    const auto height = [&](std::size_t c, std::size_t r) { return surface.at(c, r); };
    for (std::size_t r = 0; r + 1 < surface.y.size(); ++r)
        for (std::size_t c = 0; c + 1 < surface.x.size(); ++c) {
            const std::array<std::array<std::size_t, 2>, 4> corners{{{c, r}, {c + 1, r}, {c + 1, r + 1}, {c, r + 1}}};
            bool known = true;
            std::int64_t sum = 0;
            std::array<std::int64_t, 4> z{};
            for (std::size_t i = 0; i < 4; ++i) {
                known = known && !std::isnan(height(corners[i][0], corners[i][1]));
                if (known) z[i] = static_cast<std::int64_t>(height(corners[i][0], corners[i][1]));
                sum += z[i];
            }
            if (!known) continue;
            std::map<std::size_t, Place> crossed;
            for (std::size_t i = 0; i < 4; ++i) {
                const std::size_t k = (i + 1) % 4;
                if ((2 * z[i] > twice) == (2 * z[k] > twice)) continue;
                // From corner i on, (level - z_i) / (z_k - z_i) of the way.
                const std::int64_t part = twice - 2 * z[i], whole = 2 * (z[k] - z[i]);
                const auto along = [&](std::size_t from, std::size_t to) {
                    const auto f = static_cast<std::int64_t>(from), t = static_cast<std::int64_t>(to);
                    return Fraction{f * std::abs(whole) + (t - f) * (whole < 0 ? -part : part), std::abs(whole)};
                };
                crossed[i] = {along(corners[i][0], corners[k][0]), along(corners[i][1], corners[k][1])};
            }
            if (crossed.size() == 2) all.emplace_back(crossed.begin()->second, crossed.rbegin()->second);
            if (crossed.size() == 4) {
                // The corner between sides 0 and 1 is cut off if it is on the other side than the middle.
                const bool middle_high = sum >= 2 * twice, first_cut = (2 * z[1] > twice) != middle_high;
                all.emplace_back(crossed[0], crossed[first_cut ? 1 : 3]);
                all.emplace_back(crossed[2], crossed[first_cut ? 3 : 1]);
            }
        }
    return all;
}

TEST(ContourLines, AreThoseOfANaiveTwinInFractions) {
    std::mt19937 random(4);
    for (int round = 0; round < 60; ++round) {
        const PlotSurface surface = random_surface(random, 3 + random() % 6, 3 + random() % 6, round % 2 == 0 ? 0 : 15);
        const int twice = 2 * static_cast<int>(random() % 8) + 1;
        const auto rounded = [](double x, double y) { return std::pair(std::llround(x * 1e9), std::llround(y * 1e9)); };
        using Side = std::set<std::pair<long long, long long>>;
        std::multiset<Side> expected, found;
        for (const auto& [a, b] : twin(surface, twice))
            expected.insert({rounded(a.first.value(), a.second.value()), rounded(b.first.value(), b.second.value())});
        for (const ContourLine& line : contour_lines(surface, twice / 2.0))
            for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i) {
                const PlotPoint &a = line.points[i], &b = line.points[(i + 1) % line.points.size()];
                found.insert({rounded(a.x, a.y), rounded(b.x, b.y)});
            }
        EXPECT_EQ(found, expected) << round;
    }
}

TEST(ContourLines, LieBetweenTheRightSamplesAndEndOnlyAtEdges) {
    std::mt19937 random(5);
    for (int round = 0; round < 40; ++round) {
        PlotSurface surface = random_surface(random, 9, 7, round % 3 == 0 ? 10 : 0);
        for (double& x : surface.x) x = x * x + 1;  // not evenly spaced
        const double level = static_cast<double>(random() % 9);
        const auto known = [&](long long c, long long r) {
            return c >= 0 && r >= 0 && c < 9 && r < 7 &&
                   !std::isnan(surface.at(static_cast<std::size_t>(c), static_cast<std::size_t>(r)));
        };
        for (const ContourLine& line : contour_lines(surface, level))
            for (std::size_t i = 0; i < line.points.size(); ++i) {
                const PlotPoint p = line.points[i];
                const auto right = std::lower_bound(surface.x.begin(), surface.x.end(), p.x) - surface.x.begin();
                const auto above = std::lower_bound(surface.y.begin(), surface.y.end(), p.y) - surface.y.begin();
                const bool on_x = surface.x[static_cast<std::size_t>(right)] == p.x,
                           on_y = surface.y[static_cast<std::size_t>(above)] == p.y;
                ASSERT_TRUE(on_x || on_y) << "it is on a side of the grid";
                const auto c = static_cast<std::size_t>(on_x ? right : right - 1),
                           r = static_cast<std::size_t>(on_y ? above : above - 1);
                const double a = surface.at(c, r), b = surface.at(on_x ? c : c + 1, on_y ? r : r + 1);
                EXPECT_LE(std::min(a, b), level);
                EXPECT_GE(std::max(a, b), level);
                if (on_x && on_y) continue;
                const double share = on_y ? (p.x - surface.x[c]) / (surface.x[c + 1] - surface.x[c]) : p.y - surface.y[r];
                EXPECT_NEAR(a + share * (b - a), level, 1e-9);
                if (line.closed || (i > 0 && i + 1 < line.points.size())) continue;
                // Beside its end one of the two squares is not there, or is not known.
                const auto ci = static_cast<long long>(c), ri = static_cast<long long>(r);
                const bool one = on_y ? known(ci, ri - 1) && known(ci + 1, ri - 1) : known(ci - 1, ri) && known(ci - 1, ri + 1);
                const bool other = on_y ? known(ci, ri + 1) && known(ci + 1, ri + 1) : known(ci + 1, ri) && known(ci + 1, ri + 1);
                EXPECT_FALSE(one && other) << p.x << " " << p.y;
            }
    }
}

TEST(ContourLines, OfAConeAreRingsAroundIt) {
    PlotSurface cone;
    for (int i = 0; i <= 40; ++i) {
        cone.x.push_back(i - 20);
        cone.y.push_back(i - 20);
    }
    for (const double y : cone.y)
        for (const double x : cone.x) cone.z.push_back(-std::hypot(x, y));
    for (const double radius : {5.0, 10.0, 15.0}) {
        const auto lines = contour_lines(cone, -radius);
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_TRUE(lines[0].closed);
        for (const PlotPoint& p : lines[0].points) EXPECT_NEAR(std::hypot(p.x, p.y), radius, 0.05);
    }
    EXPECT_FALSE(contour_lines(cone, -24)[0].closed);
    for (std::size_t i = 0; i < cone.z.size(); ++i)
        if (cone.x[i % 41] > 0 && std::abs(cone.y[i / 41]) < 2) cone.z[i] = NAN;
    EXPECT_FALSE(contour_lines(cone, -10)[0].closed) << "a hole opens it";
}

TEST(ContourLines, LevelsAreRoundAndWithin) {
    std::mt19937 random(6);
    for (int round = 0; round < 300; ++round) {
        PlotSurface surface = random_surface(random, 4, 4, 10);
        const double factor = std::pow(10.0, static_cast<double>(random() % 7) - 3);
        for (double& z : surface.z) z = z * factor - factor;
        const int most = 3 + static_cast<int>(random() % 8);
        const auto levels = contour_levels(surface, most);
        double low = INFINITY, high = -INFINITY;
        for (const double z : surface.z)
            if (!std::isnan(z)) low = std::min(low, z), high = std::max(high, z);
        EXPECT_EQ(levels.empty(), !(low < high));
        EXPECT_LE(levels.size(), static_cast<std::size_t>(most));
        for (const double level : levels) {
            EXPECT_GT(level, low);
            EXPECT_LT(level, high);
            EXPECT_FALSE(contour_lines(surface, level).empty() &&
                         std::none_of(surface.z.begin(), surface.z.end(), [](double z) { return std::isnan(z); }))
                << level;
        }
    }
}

}  // namespace
}  // namespace tactics::contour_lines_test
