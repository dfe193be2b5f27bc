// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/bar_names.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactics {

namespace {

// What is free before a side that looks that way: as wide as a word, to the next bar or the edge of the drawing, up to what words
// need.
double room_before(const ChartBars& found, Point corner, Point at, Point out, double most) {
    const auto off = [&](double x, double y) { return (x - at.x) * out.x + (y - at.y) * out.y; };
    double room = std::min(most, std::max(off(0, 0), off(corner.x, corner.y)));
    for (const auto& [bar, look] : found.bars) {
        const double across =
            out.x != 0 ? std::max(bar.top - at.y, at.y - bar.bottom) : std::max(bar.left - at.x, at.x - bar.right);
        const double one = off(bar.left, bar.top), other = off(bar.right, bar.bottom);
        if (across <= most / 2 && std::max(one, other) > most / 80) room = std::min(room, std::max(0.0, std::min(one, other)));
    }
    return room;
}

}  // namespace

Point place_of_bar_name(const ChartBars& bars, std::size_t look, double width, double height, double room) {
    constexpr double kLine = 0.4;      // of what words need: as high as a line of braille with its gaps
    constexpr double kAtBase = 0.025;  // of it, too
    Point best;
    double best_room = -1, best_far = 0;
    const auto offer = [&](Point at, double free, double far) {
        if (free < best_room || (free == best_room && far <= best_far)) return;
        best = at;
        best_room = free;
        best_far = far;
    };
    for (const auto& [bar, own] : bars.bars) {
        if (own != look) continue;
        const Point middle = bar.middle();
        for (const auto& [at, out] :
             {std::pair{Point{middle.x, bar.top}, Point{0, -1}}, std::pair{Point{middle.x, bar.bottom}, Point{0, 1}},
              std::pair{Point{bar.left, middle.y}, Point{-1, 0}}, std::pair{Point{bar.right, middle.y}, Point{1, 0}}}) {
            const double far = std::abs((bars.lying ? at.x : at.y) - bars.base);
            const bool is_base = far < kAtBase * room && (bars.lying ? out.x : out.y) != 0;
            offer(at, is_base ? 0 : room_before(bars, {width, height}, at, out, room), far);
        }
        offer(middle, std::min({room, bar.width(), bar.height() / kLine}), 0);
    }
    return best;
}

}  // namespace tactics
