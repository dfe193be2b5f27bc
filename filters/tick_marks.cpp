// SPDX-License-Identifier: Apache-2.0
#include "filters/tick_marks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>

#include "filters/thin_strokes.h"

namespace tactics {

namespace {

// On the page, mm; settings, all. Shorter ticks are hardly felt, and in the way of the braille below them.
constexpr double kShortestMark = 2, kLongestMark = 6, kShortestAxis = 25, kApartMarks = 5;
constexpr std::size_t kFewestTicks = 3;

// An upright stroke at a level axis: so far it reaches above and below.
struct Tick {
    ThinStroke line;
    int above = 0, below = 0;
    bool like(const Tick& other) const { return std::abs(above - other.above) <= 1 && std::abs(below - other.below) <= 1; }
};

// The ground is all around that end, as `beyond` it.
bool ends_on_ground(const Image& grey, const ThinStroke& line, int beyond) {
    constexpr int kStep = 20;  // grey levels
    if (beyond < 0 || beyond >= grey.height) return false;
    const int own = grey_at(grey, static_cast<int>(line.middle()), beyond);
    const bool above = beyond < line.begin;
    for (int y = above ? beyond : line.end - 2; y <= (above ? line.begin + 1 : beyond); ++y)
        for (const int x : {line.low - 3, line.high + 2})
            if (std::abs(grey_at(grey, x, y) - own) >= kStep) return false;
    return true;
}

std::vector<Tick> ticks_at(const ThinStroke& axis, const std::vector<ThinStroke>& uprights, const Image& grey, double mm) {
    constexpr int kNear = 2;
    const double least = kShortestMark / mm;
    std::vector<Tick> ticks;
    for (const ThinStroke& line : uprights) {
        if (line.length() * mm > 2 * kLongestMark || line.end < axis.low - 1 || line.begin > axis.high + 1 ||
            line.low < axis.begin - kNear || line.high > axis.end + kNear)
            continue;
        Tick tick{line, std::max(0, axis.low - line.begin), std::max(0, line.end - axis.high)};
        if (tick.above < least) tick.above = 0;
        if (tick.below < least) tick.below = 0;
        if (std::max(tick.above, tick.below) * mm > kLongestMark || tick.above + tick.below == 0) continue;
        if ((tick.above == 0 || ends_on_ground(grey, line, line.begin - 3)) &&
            (tick.below == 0 || ends_on_ground(grey, line, line.end + 2)))
            ticks.push_back(tick);
    }
    std::sort(ticks.begin(), ticks.end(), [](const Tick& a, const Tick& b) { return a.line.low < b.line.low; });
    return ticks;
}

bool have_room(const std::vector<Tick>& ticks, double mm) {
    return std::adjacent_find(ticks.begin(), ticks.end(), [&](const Tick& one, const Tick& next) {
               return (next.line.middle() - one.line.middle()) * mm < kApartMarks;
           }) == ticks.end();
}

// Those of one length, the longest first: between them shorter ones may divide the steps.
std::vector<Tick> alike(std::vector<Tick> ticks, double mm) {
    while (!ticks.empty()) {
        const Tick longest = *std::max_element(
            ticks.begin(), ticks.end(), [](const Tick& a, const Tick& b) { return a.above + a.below < b.above + b.below; });
        std::vector<Tick> group;
        std::copy_if(ticks.begin(), ticks.end(), std::back_inserter(group), [&](const Tick& tick) { return tick.like(longest); });
        std::erase_if(ticks, [&](const Tick& tick) { return tick.like(longest); });
        if (group.size() >= kFewestTicks && have_room(group, mm)) return group;
    }
    return {};
}

// The axis stays, whose end a tick may be.
void take_outside(const ThinStroke& axis, const ThinStroke& tick, bool level, Image& picture) {
    ThinStroke above = tick, below = tick;
    above.end = std::min(above.end, axis.low - kStrokeHalo);
    below.begin = std::max(below.begin, axis.high + kStrokeHalo);
    for (const ThinStroke& part : {above, below})
        if (part.length() > 0) take_out(picture, part, level);
}

void take_ticks_of(const std::vector<ThinStroke>& levels, const std::vector<ThinStroke>& uprights, const Image& grey, bool level,
                   double mm, Image& picture, std::vector<std::array<Point, 2>>& taken) {
    for (const ThinStroke& axis : levels) {
        if (axis.length() * mm < kShortestAxis) continue;
        for (const Tick& tick : alike(ticks_at(axis, uprights, grey, mm), mm)) {
            const int middle = static_cast<int>(std::lround(axis.middle()));
            ThinStroke line = tick.line;
            line.begin = tick.above > 0 ? line.begin : middle;
            line.end = tick.below > 0 ? line.end : middle;
            taken.push_back(ends_of(line, level));
            take_outside(axis, tick.line, level, picture);
        }
    }
}

}  // namespace

std::vector<std::array<Point, 2>> take_tick_marks(Image& picture) {
    const double mm = picture.mm_per_pixel;
    const ThinStrokes strokes = thin_strokes_in(picture, kShortestMark);
    std::vector<std::array<Point, 2>> taken;
    take_ticks_of(strokes.level, strokes.upright, strokes.grey, false, mm, picture, taken);
    take_ticks_of(strokes.upright, strokes.level, strokes.turned, true, mm, picture, taken);
    return taken;
}

}  // namespace tactics
