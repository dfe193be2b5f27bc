// SPDX-License-Identifier: Apache-2.0
#include "filters/bar_legend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "filters/inked_bars.h"

namespace tactics {

namespace {

constexpr double kPageWidth = 250;  // mm of the longer side
constexpr std::size_t kMostMatched = 6;
// How much better than any other way of matching them the best one is, and what a sample may be off the kind that is its own: one
// of them may be so for want of another. Settings.
constexpr double kClear = 1, kOwn = 3;

struct Matching {
    std::vector<std::size_t> kind;  // of each sample
    double cost = 1e9, next = 1e9;
};

Matching best_matching(const std::vector<std::vector<double>>& costs) {
    const std::size_t count = costs.size(), kinds = costs[0].size();
    std::vector<std::size_t> order(kinds);
    std::iota(order.begin(), order.end(), std::size_t{0});
    Matching best;
    do {
        // The same for each order of those that are left over.
        if (!std::is_sorted(order.begin() + static_cast<std::ptrdiff_t>(count), order.end())) continue;
        double cost = 0;
        for (std::size_t i = 0; i < count; ++i) cost += costs[i][order[i]];
        if (cost < best.cost) {
            best.next = best.cost;
            best.cost = cost;
            best.kind.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
        } else {
            best.next = std::min(best.next, cost);
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

BarFill sample_fill(const Image& picture, const PixelColour& ground, const PixelBox& sample) {
    constexpr int kFrame = 3, kLeast = 3;  // pixels
    const auto within = [&](int off) {
        return PixelBox{sample.left + off, sample.top + off, sample.right - off, sample.bottom - off};
    };
    PixelBox box = within(kFrame);
    for (int off = kFrame; off > 0 && std::min(box.width(), box.height()) < kLeast;) box = within(--off);
    return bar_fill_of(picture, cell_at(picture, ground, box));
}

// The end that is farthest from the base, where no bar of another kind is on it: there is most room beside it. Else in the
// largest one.
Point place_on(const InkedBars& found, std::size_t kind) {
    constexpr double kOn = 2;  // pixels
    const auto end_of = [&](const InkedBar& bar) {
        if (!found.lying) return Point{(bar.left + bar.right) / 2, bar.bottom <= found.base + kOn ? bar.top : bar.bottom};
        return Point{bar.left >= found.base - kOn ? bar.right : bar.left, (bar.top + bar.bottom) / 2};
    };
    const auto is_free = [&](Point end) {
        return std::count_if(found.bars.begin(), found.bars.end(), [&](const InkedBar& bar) {
                   return end.x > bar.left - kOn && end.x < bar.right + kOn && end.y > bar.top - kOn && end.y < bar.bottom + kOn;
               }) == 1;
    };
    double most = 0, largest = 0;
    Point at, middle;
    for (const InkedBar& bar : found.bars) {
        if (bar.fill != kind) continue;
        const Point end = end_of(bar);
        const double far = std::abs((found.lying ? end.x : end.y) - found.base),
                     size = (bar.right - bar.left) * (bar.bottom - bar.top);
        if (far > most && is_free(end)) {
            most = far;
            at = end;
        }
        if (size > largest) {
            largest = size;
            middle = {(bar.left + bar.right) / 2, (bar.top + bar.bottom) / 2};
        }
    }
    return most > 0 ? at : middle;
}

}  // namespace

std::vector<Point> bars_like(const Image& picture, const PixelColour& ground, const std::vector<PixelBox>& samples) {
    if (samples.size() < 2) return {};
    const auto found = inked_bars_in(picture, ground, kPageWidth / std::max(picture.width, picture.height));
    if (!found || found->fills.size() < samples.size() || found->fills.size() > kMostMatched) return {};
    std::vector<std::vector<double>> costs;
    for (const PixelBox& box : samples) {
        const BarFill fill = sample_fill(picture, ground, box);
        costs.emplace_back();
        for (const BarFill& kind : found->fills) costs.back().push_back(unlike(fill, kind));
    }
    const Matching matching = best_matching(costs);
    std::size_t off = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) off += costs[i][matching.kind[i]] > kOwn ? 1 : 0;
    if (off > 1 || matching.next - matching.cost < kClear) return {};
    std::vector<Point> places;
    for (const std::size_t kind : matching.kind) places.push_back(place_on(*found, kind));
    return places;
}

}  // namespace tactics
