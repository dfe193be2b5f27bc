// SPDX-License-Identifier: Apache-2.0
#include "filters/bar_legend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "filters/inked_bars.h"

namespace tactics {

namespace {

constexpr double kPageWidth = 250;  // mm of the longer side
constexpr double kWords = 24;       // mm that words need
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

// A side of a bar where words may stand, and which way is out.
struct FreeSide {
    Point at, out;
    double room = 0;  // pixels to the next bar or the edge of the picture, up to what words need
    double far = 0;   // from the base
};

// What is free before a side, so wide as a word.
double room_at(const InkedBars& found, const Image& picture, Point at, Point out, double most) {
    const double half = most / 2;
    double room = std::min(most, out.x > 0 ? picture.width - at.x : out.x < 0 ? at.x : out.y > 0 ? picture.height - at.y : at.y);
    for (const InkedBar& bar : found.bars) {
        const double across =
            out.x != 0 ? std::max(bar.top - at.y, at.y - bar.bottom) : std::max(bar.left - at.x, at.x - bar.right);
        if (across > half) continue;
        const double near = out.x > 0   ? bar.left - at.x
                            : out.x < 0 ? at.x - bar.right
                            : out.y > 0 ? bar.top - at.y
                                        : at.y - bar.bottom;
        const double far = out.x > 0   ? bar.right - at.x
                           : out.x < 0 ? at.x - bar.left
                           : out.y > 0 ? bar.bottom - at.y
                                       : at.y - bar.top;
        if (far > 1) room = std::min(room, std::max(0.0, near));
    }
    return room;
}

// Of all bars of its kind the side with most room, and of these the one farthest from the base; or within one.
Point place_on(const InkedBars& found, const Image& picture, std::size_t kind, double most) {
    FreeSide best;
    best.room = -1;
    for (const InkedBar& bar : found.bars) {
        if (bar.fill != kind) continue;
        const double x = (bar.left + bar.right) / 2, y = (bar.top + bar.bottom) / 2;
        for (const auto& [at, out] : {std::pair{Point{x, bar.top}, Point{0, -1}}, std::pair{Point{x, bar.bottom}, Point{0, 1}},
                                      std::pair{Point{bar.left, y}, Point{-1, 0}}, std::pair{Point{bar.right, y}, Point{1, 0}}}) {
            const double far = std::abs((found.lying ? at.x : at.y) - found.base);
            const bool is_base = far < 2 && (found.lying ? out.x : out.y) != 0;
            const double room = is_base ? 0 : room_at(found, picture, at, out, most);
            if (room > best.room || (room == best.room && far > best.far)) best = {at, out, room, far};
        }
        constexpr double kLine = 0.4;  // of what words need: as high as a line of braille with its gaps
        const double within = std::min({most, bar.right - bar.left, (bar.bottom - bar.top) / kLine});
        if (within > best.room) best = {{x, y}, {}, within, 0};
    }
    return best.at;
}

}  // namespace

std::vector<Point> bars_like(const Image& picture, const PixelColour& ground, const std::vector<PixelBox>& samples) {
    if (samples.size() < 2) return {};
    const double mm = kPageWidth / std::max(picture.width, picture.height);
    const auto found = inked_bars_in(picture, ground, mm);
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
    for (const std::size_t kind : matching.kind) places.push_back(place_on(*found, picture, kind, kWords / mm));
    return places;
}

}  // namespace tactics
