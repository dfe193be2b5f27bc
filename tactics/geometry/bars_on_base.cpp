// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/bars_on_base.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tactics {

namespace {

constexpr std::size_t kFewestBars = 3;

StandingBar standing(const BarRectangle& rectangle, std::size_t number, bool lying) {
    const Box& b = rectangle.box;
    if (lying) return {b.top, b.bottom, -b.right, -b.left, number, rectangle.blank};
    return {b.left, b.right, b.top, b.bottom, number, rectangle.blank};
}

// What is filled and stands at that height, and what stands on it.
std::vector<StandingBar> bars_at(double base, const std::vector<StandingBar>& all, const BarSlack& slack) {
    std::vector<StandingBar> bars;
    std::vector<bool> taken(all.size());
    const auto take = [&](std::size_t i) {
        bars.push_back(all[i]);
        taken[i] = true;
    };
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!all[i].blank && std::abs(all[i].foot - base) <= slack.touch) take(i);
    if (bars.size() < kFewestBars) return {};
    // Those below the base, and blank ones as wide as one that is filled.
    const std::size_t filled = bars.size();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (taken[i]) continue;
        const bool as_wide =
            std::any_of(bars.begin(), bars.begin() + static_cast<std::ptrdiff_t>(filled),
                        [&](const StandingBar& bar) { return std::abs(bar.width() - all[i].width()) <= slack.touch; });
        const double end = all[i].blank ? all[i].foot : all[i].top;
        if (as_wide && std::abs(end - base) <= slack.touch) take(i);
    }
    for (std::size_t k = 0; k < bars.size(); ++k)
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!taken[i] && is_stacked_on(all[i], bars[k], slack)) take(i);
    return bars;
}

double area_of(const std::vector<StandingBar>& bars) {
    return std::accumulate(bars.begin(), bars.end(), 0.0, [](double sum, const StandingBar& bar) { return sum + bar.area(); });
}

}  // namespace

Box as_it_lies(const StandingBar& bar, bool lying) {
    if (lying) return {-bar.foot, bar.left, -bar.top, bar.right};
    return {bar.left, bar.top, bar.right, bar.foot};
}

bool is_stacked_on(const StandingBar& upper, const StandingBar& lower, const BarSlack& slack) {
    constexpr double kAsWide = 0.12;  // of its width on each side
    const double off = std::max(slack.touch, kAsWide * lower.width());
    return std::abs(upper.left - lower.left) <= off && std::abs(upper.right - lower.right) <= off &&
           std::abs(upper.foot - lower.top) <= slack.stacked;
}

BarsOnBase bars_on_base(std::span<const BarRectangle> rectangles, const BarSlack& slack) {
    const double one_base = slack.touch / 4;  // feet that are closer need not be tried again
    BarsOnBase best;
    double most = 0;
    for (const bool lying : {false, true}) {
        std::vector<StandingBar> all;
        for (std::size_t i = 0; i < rectangles.size(); ++i) all.push_back(standing(rectangles[i], i, lying));
        std::vector<double> tried;
        for (const StandingBar& one : all) {
            const bool again =
                std::any_of(tried.begin(), tried.end(), [&](double t) { return std::abs(t - one.foot) < one_base; });
            if (one.blank || again) continue;
            tried.push_back(one.foot);
            std::vector<StandingBar> bars = bars_at(one.foot, all, slack);
            if (const double area = area_of(bars); area > most) {
                most = area;
                best = {std::move(bars), one.foot, lying};
            }
        }
    }
    return best;
}

bool stand_as_boxes(std::span<const StandingBar> bars, double touch) {
    constexpr double kMostCellsOfTable = 0.6;
    std::vector<double> ends, columns;
    const auto add = [touch](std::vector<double>& values, double value) {
        if (std::none_of(values.begin(), values.end(), [&](double one) { return std::abs(one - value) <= touch; }))
            values.push_back(value);
    };
    for (const StandingBar& bar : bars) {
        add(ends, bar.top);
        add(columns, bar.left);
    }
    const double places = static_cast<double>(ends.size()) * static_cast<double>(columns.size());
    return static_cast<double>(bars.size()) >= (ends.size() > 1 ? kMostCellsOfTable : 1) * places;
}

std::vector<std::vector<std::size_t>> bar_groups(const BarsOnBase& found, const BarSlack& slack) {
    constexpr double kBetween = 0.5;
    const std::vector<StandingBar>& bars = found.bars;
    std::vector<std::size_t> order(bars.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const double off = bars[a].left - bars[b].left;
        return std::abs(off) > slack.touch ? off < 0 : bars[a].top > bars[b].top;
    });
    const bool stacked = std::any_of(bars.begin(), bars.end(), [&](const StandingBar& bar) {
        return std::min(std::abs(bar.foot - found.base), std::abs(bar.top - found.base)) > slack.stacked;
    });
    std::vector<std::vector<std::size_t>> groups;
    for (const std::size_t i : order) {
        const StandingBar* before = groups.empty() ? nullptr : &bars[groups.back().back()];
        const bool goes_on = before != nullptr && (stacked ? std::abs(bars[i].left - before->left) <= slack.touch
                                                           : bars[i].left - before->right < kBetween * before->width());
        if (!goes_on) groups.emplace_back();
        groups.back().push_back(i);
    }
    return groups;
}

}  // namespace tactics
