// SPDX-License-Identifier: Apache-2.0
#include "filters/page_stakes.h"

#include <algorithm>
#include <cmath>

#include "filters/outline_choice.h"

namespace tactics {

namespace {

constexpr double kMain = 0.4;       // of completeness
constexpr double kShortMain = 0.7;  // diagonals: or the likeliest for a thing would count as one on a page where none is expected
constexpr double kMost = 4.5;       // diagonals: the budget of line on A4; on smaller sheets the same is at stake
constexpr int kStakeRounds = 3;     // after two the pages hardly change
constexpr double kFirstPrice = 0.55;  // the price at first
constexpr double kCheaper = 0.1;      // where nothing is drawn

// Steps, each times its chance.
struct Sums {
    double length = 0, agreed = 0, main = 0;
};

template <typename Takes>
Sums sums_of(const RegionTree& tree, const ArcChances& chances, Takes takes) {
    Sums sums;
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        if (!takes(tree.arcs[i])) continue;
        const double length = steps_of(tree.arcs[i]);
        sums.length += length;
        sums.agreed += length * static_cast<double>(chances.drawn[i]);
        sums.main += length * static_cast<double>(chances.main[i]);
    }
    return sums;
}

}  // namespace

Stakes stakes_of(const RegionTree& tree, const ArcChances& chances, double sure) {
    const double diagonal = std::hypot(tree.width, tree.height);
    const Sums all = sums_of(tree, chances, [](const RegionArc&) { return true; });
    Stakes stakes{chances.drawn, kFirstPrice};
    if (all.agreed <= 0) return stakes;
    const double main = all.main + kShortMain * diagonal;
    for (int i = 0; i < kStakeRounds; ++i) {
        const Parts parts = best_parts(tree, stakes.worth, stakes.price, kMost * diagonal);
        const Sums drawn = sums_of(tree, chances, [&](const RegionArc& arc) { return parts.divides(arc); });
        if (drawn.length <= 0) {
            stakes.price = std::max(stakes.price - kCheaper, kFaint);
            continue;
        }
        // The slopes by a step that is drawn, by one that people agree on, and by one of the main thing; all of them over the
        // second, so that a chance is worth what it is.
        const double by_step = sure * drawn.agreed / (drawn.length * drawn.length);
        const double by_agreed = std::max(sure / drawn.length + (1 - sure) * (1 - kMain) / all.agreed, 1e-12);
        const double by_main = (1 - sure) * kMain / main;
        stakes.price = by_step / by_agreed;
        for (std::size_t k = 0; k < stakes.worth.size(); ++k)
            stakes.worth[k] = chances.drawn[k] + static_cast<float>(by_main / by_agreed) * chances.main[k];
    }
    return stakes;
}

}  // namespace tactics
