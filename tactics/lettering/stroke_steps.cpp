// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/stroke_steps.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace tactics {

namespace {

constexpr int kThickest = 4, kTimesAsLong = 2;  // pixels of a bar, and its length
constexpr int kGap = 2;                         // pixels from one to the next
constexpr std::size_t kLeastSteps = 4;          // a stroke of a letter seldom comes in more than two

// A bar along a line that runs from `from` to `to`, and what it covers beside it.
struct StepBar {
    int from, to, low, high;
    std::size_t piece;
};

// From its end the other goes on, a step aside.
bool goes_on(const StepBar& one, const StepBar& other, bool rising) {
    const int ahead = other.from - one.to, aside = rising ? other.low - one.high : one.low - other.high;
    const int own = one.high - one.low, others = other.high - other.low;
    return ahead >= -1 && ahead <= kGap && aside >= -std::min(own, others) + 1 && aside <= 1 && std::abs(own - others) <= 1;
}

// Of `bars`, sorted by where they begin, those that are steps of a line.
void mark_steps(const std::vector<StepBar>& bars, bool rising, std::vector<bool>& steps) {
    std::vector<std::size_t> before(bars.size(), bars.size()), count(bars.size(), 1);
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const auto least = std::lower_bound(bars.begin() + static_cast<std::ptrdiff_t>(i), bars.end(), bars[i].to - 1,
                                            [](const StepBar& bar, int from) { return bar.from < from; });
        for (auto k = static_cast<std::size_t>(least - bars.begin()); k < bars.size() && bars[k].from <= bars[i].to + kGap; ++k)
            if (k != i && goes_on(bars[i], bars[k], rising) && count[i] + 1 > count[k]) {
                before[k] = i;
                count[k] = count[i] + 1;
            }
    }
    for (std::size_t i = 0; i < bars.size(); ++i)
        for (std::size_t at = i; count[i] >= kLeastSteps && at < bars.size() && !steps[bars[at].piece]; at = before[at])
            steps[bars[at].piece] = true;
}

}  // namespace

void drop_stroke_steps(std::vector<InkPiece>& pieces) {
    std::vector<bool> steps(pieces.size(), false);
    for (const bool upright : {false, true}) {
        std::vector<StepBar> bars;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const PixelBox& box = pieces[i].box;
            const StepBar bar = upright ? StepBar{box.top, box.bottom, box.left, box.right, i}
                                        : StepBar{box.left, box.right, box.top, box.bottom, i};
            if (bar.high - bar.low <= kThickest && bar.to - bar.from >= kTimesAsLong * (bar.high - bar.low)) bars.push_back(bar);
        }
        std::sort(bars.begin(), bars.end(), [](const StepBar& a, const StepBar& b) { return a.from < b.from; });
        for (const bool rising : {false, true}) mark_steps(bars, rising, steps);
    }
    std::size_t at = 0;
    std::erase_if(pieces, [&](const InkPiece&) { return steps[at++]; });
}

}  // namespace tactics
