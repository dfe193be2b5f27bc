// SPDX-License-Identifier: Apache-2.0
// Level lines through shapes, against distances measured point by point.
#include "tactics/geometry/spans.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tactics/geometry/distance.h"
#include "tests/rules/pages.h"

namespace tactics::spans_test {
namespace {

TEST(Spans, WithinIsWhatIsNoFurtherThanTheReach) {
    tests::Dice chance(5);
    for (int round = 0; round < 200; ++round) {
        const double ax = chance.between(0, 20), ay = chance.between(0, 20), bx = chance.between(0, 20),
                     by = chance.between(0, 20);
        const Segment side{{ax, ay}, round % 10 == 0 ? Point{ax, ay} : Point{bx, by}};
        const double reach = chance.between(0.1, 4), y = chance.between(0, 20);
        Span span;
        const bool any = span_within(side.a, side.b, reach, y, span);
        for (double x = -5; x < 25; x += 0.05) {
            const Point p{x, y};
            const double off = distance(p, nearest_on(side, p)) - reach;
            if (std::abs(off) < 1e-9) continue;
            EXPECT_EQ(any && x >= span.first && x <= span.second, off < 0) << "round " << round << " at " << x;
        }
    }
}

TEST(Spans, WithoutLeavesWhatIsInNoOther) {
    tests::Dice chance(6);
    for (int round = 0; round < 300; ++round) {
        std::vector<Span> spans, taken;
        double at = 0;
        for (std::size_t i = chance.below(5); i > 0; --i) {
            const double from = at + chance.between(0, 2);
            spans.push_back({from, at = from + chance.between(0.1, 4)});
        }
        for (std::size_t i = chance.below(6); i > 0; --i) {
            const double from = chance.between(0, 20);
            taken.push_back({from, from + chance.between(0.1, 5)});
        }
        std::sort(taken.begin(), taken.end());
        const std::vector<Span> left = without(spans, taken);
        const auto in = [](const std::vector<Span>& all, double x) {
            return std::any_of(all.begin(), all.end(), [x](const Span& s) { return x > s.first && x < s.second; });
        };
        for (double x = 0.013; x < 30; x += 0.05)
            EXPECT_EQ(in(left, x), in(spans, x) && !in(taken, x)) << "round " << round << " at " << x;
        for (std::size_t i = 0; i < left.size(); ++i) {
            EXPECT_LT(left[i].first, left[i].second);
            EXPECT_TRUE(i == 0 || left[i - 1].second <= left[i].first);
        }
    }
}

}  // namespace
}  // namespace tactics::spans_test
