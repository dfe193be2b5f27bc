// SPDX-License-Identifier: Apache-2.0
#include "filters/bar_legend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "filters/darken.h"
#include "filters/lab.h"
#include "tactics/layout/bar_names.h"

namespace tactics {

namespace {

constexpr double kPageWidth = 250;  // mm of the longer side
constexpr double kWords = 24;       // mm that words need
constexpr std::size_t kMostMatched = 6;
// What a sample may be off the kind that is its own; one of them may be so for want of another. How much worse than the best way
// of matching them the one by their order may be, and how much better than any other the best one is, if it has another order. Of
// two samples that look alike neither says anything. Settings.
constexpr double kOwn = 3, kByOrder = 2, kClear = 3, kAlikeFills = 0.6;

double pixel_of_page(const Image& picture) { return kPageWidth / std::max(picture.width, picture.height); }

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

Point middle_of(const InkedBar& bar) { return {(bar.left + bar.right) / 2, (bar.top + bar.bottom) / 2}; }

bool is_stacked(const InkedBars& found) {
    constexpr double kOffBase = 4;  // pixels
    return std::any_of(found.bars.begin(), found.bars.end(), [&](const InkedBar& bar) {
        const double off = found.lying ? std::min(std::abs(bar.left - found.base), std::abs(bar.right - found.base))
                                       : std::min(std::abs(bar.top - found.base), std::abs(bar.bottom - found.base));
        return off > kOffBase;
    });
}

// Kinds as they follow each other: from the base on where bars stand on each other, else to the right, or down.
std::vector<std::size_t> order_of_kinds(const InkedBars& found, bool stacked) {
    const bool across = stacked == found.lying;
    const auto place = [&](const InkedBar& bar) {
        const Point at = middle_of(bar);
        return across ? at.x : stacked ? -at.y : at.y;
    };
    // How often it comes after the nearest bar of another kind.
    std::vector<int> later(found.fills.size(), 0);
    for (const InkedBar& one : found.bars)
        for (std::size_t kind = 0; kind < found.fills.size(); ++kind) {
            const InkedBar* nearest = nullptr;
            for (const InkedBar& other : found.bars)
                if (other.fill == kind && kind != one.fill &&
                    (nearest == nullptr ||
                     distance(middle_of(one), middle_of(other)) < distance(middle_of(one), middle_of(*nearest))))
                    nearest = &other;
            if (nearest != nullptr) later[one.fill] += place(one) > place(*nearest) ? 1 : -1;
        }
    std::vector<std::size_t> order(found.fills.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return later[a] < later[b]; });
    return order;
}

// The kind of each sample by their order, and by the other order, where tools have both: in a column beside bars that stand on
// each other, and beside groups of lying bars.
std::vector<std::vector<std::size_t>> kinds_by_order(const InkedBars& found, const std::vector<PixelBox>& samples) {
    if (found.fills.size() != samples.size()) return {};
    const auto [left, right] =
        std::minmax_element(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.left < b.left; });
    const auto [top, bottom] =
        std::minmax_element(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.top < b.top; });
    const bool in_row = right->left - left->left > bottom->top - top->top, stacked = is_stacked(found);
    std::vector<std::size_t> read(samples.size());
    std::iota(read.begin(), read.end(), std::size_t{0});
    std::sort(read.begin(), read.end(), [&](std::size_t a, std::size_t b) {
        return in_row ? samples[a].left < samples[b].left : samples[a].top < samples[b].top;
    });
    std::vector<std::size_t> order = order_of_kinds(found, stacked);
    std::vector<std::vector<std::size_t>> all;
    const bool both = stacked ? !in_row && !found.lying : found.lying;
    for (int turn = 0; turn < (both ? 2 : 1); ++turn) {
        all.emplace_back(samples.size());
        for (std::size_t i = 0; i < read.size(); ++i) all.back()[read[i]] = order[i];
        std::reverse(order.begin(), order.end());
    }
    return all;
}

// The kind of each sample; empty where that is not clear.
std::vector<std::size_t> kinds_of_samples(const std::vector<std::vector<double>>& costs,
                                          const std::vector<std::vector<std::size_t>>& by_order) {
    const Matching best = best_matching(costs);
    const auto cost_of = [&](const std::vector<std::size_t>& kinds) {
        double cost = 0;
        for (std::size_t i = 0; i < kinds.size(); ++i) cost += costs[i][kinds[i]];
        return cost;
    };
    std::vector<std::size_t> kinds = best.next - best.cost >= kClear ? best.kind : std::vector<std::size_t>();
    const auto ordered =
        std::min_element(by_order.begin(), by_order.end(), [&](const auto& a, const auto& b) { return cost_of(a) < cost_of(b); });
    if (ordered != by_order.end() && cost_of(*ordered) <= best.cost + kByOrder) kinds = *ordered;
    std::size_t off = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) off += costs[i][kinds[i]] > kOwn ? 1 : 0;
    return off > 1 ? std::vector<std::size_t>() : kinds;
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

// There are about as many bars of each kind: else some are missing, or one kind was taken for two.
bool is_even(const InkedBars& found) {
    std::vector<std::ptrdiff_t> counts;
    for (std::size_t kind = 0; kind < found.fills.size(); ++kind)
        counts.push_back(
            std::count_if(found.bars.begin(), found.bars.end(), [&](const InkedBar& bar) { return bar.fill == kind; }));
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    return 2 * *least >= *most;
}

}  // namespace

std::optional<InkedBars> bars_of(const Image& picture) {
    return inked_bars_in(picture, ground_of(picture), pixel_of_page(picture));
}

std::vector<Point> places_like(const std::vector<PixelBox>& samples, const InkedBars& bars, const Image& picture) {
    if (samples.size() < 2 || bars.fills.size() < samples.size() || bars.fills.size() > kMostMatched || !is_even(bars)) return {};
    const PixelColour ground = ground_of(picture);
    std::vector<std::vector<double>> costs;
    std::vector<BarFill> fills;
    for (const PixelBox& box : samples) {
        const BarFill fill = sample_fill(picture, ground, box);
        if (std::any_of(fills.begin(), fills.end(), [&](const BarFill& other) { return unlike(fill, other) < kAlikeFills; }))
            return {};
        fills.push_back(fill);
        costs.emplace_back();
        for (const BarFill& kind : bars.fills) costs.back().push_back(unlike(fill, kind));
    }
    const ChartBars in_pixels = chart_bars_of(bars, 1);
    const double room = kWords / pixel_of_page(picture);
    std::vector<Point> places;
    for (const std::size_t kind : kinds_of_samples(costs, kinds_by_order(bars, samples)))
        places.push_back(place_of_bar_name(in_pixels, kind, picture.width, picture.height, room));
    return places;
}

}  // namespace tactics
