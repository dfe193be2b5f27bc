// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/lay_flat.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tactics/solid/growth.h"
#include "tactics/solid/rated.h"

namespace tactics {

namespace {

// Which fold comes first. All have their cases: a staircase unfolds breadth
// first, a roof by its longest sides.
constexpr Strategy kStrategies[] = {Strategy::longest, Strategy::broadest, Strategy::largest, Strategy::nearest,
                                    Strategy::deepest};

constexpr double kSizes[] = {0, 1.0, 0.75};  // how small, of the scale of what lies where it is; 0: as it comes
constexpr double kHalfSize = 0.05;           // of the rating that it costs if all is half as large

// Of the parts, that which is too small to be felt.
double lost(const std::vector<ModelPart>& parts, double least) {
    const auto is_small = [&](const ModelPart& part) { return extent_of(part) < least; };
    return static_cast<double>(std::count_if(parts.begin(), parts.end(), is_small)) /
           static_cast<double>(std::max<std::size_t>(parts.size(), 1));
}

// xorshift64 (G. Marsaglia, 2003): the same layouts on every machine.
class Chance {
public:
    double next() {  // 0 to 1
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_ = 0x9E3779B97F4A7C15ull;
};

}  // namespace

int layouts_tried(int effort, std::size_t panels) {
    constexpr double kAsWished = 200;  // panels: a few pieces of furniture
    return static_cast<int>(effort * std::min(1.0, kAsWished / static_cast<double>(std::max<std::size_t>(panels, 1))));
}

FlatLayout lay_flat(const std::vector<ModelPart>& parts, const Panels& panels, const std::vector<std::uint32_t>& thing,
                    const ViewPlane& view, const LayoutWish& wish) {
    FlatLayout best;
    Growth growth(parts, panels, thing, view, wish);
    const double whole = growth.scale_of_kept();
    const auto consider = [&](FlatLayout layout) {
        layout.rating = rating_of(layout, parts, panels, wish.reader);
        if (whole > 0) {
            const double scale = scale_in(wish.room, box_of(layout));
            layout.rating.asked += kHalfSize * std::max(0.0, std::log2(whole / scale));
            layout.rating.shown -= lost(parts, wish.shortest / scale) / 3;
        }
        if (best.panels.empty() || layout.rating.value() > best.rating.value() + kAsGood) best = std::move(layout);
    };
    std::vector<double> favour(panels.panels.size(), 1);
    for (const Strategy strategy : kStrategies) consider(growth.grown(strategy, favour));
    const std::size_t sizes = whole > 0 ? std::size(kSizes) : 1;
    for (std::size_t size = 1; size < sizes; ++size) consider(growth.grown(kStrategies[0], favour, kSizes[size] * whole));
    Chance chance;
    const int tried = layouts_tried(wish.effort, panels.panels.size());
    for (int i = 0; i < tried; ++i) {
        for (double& one : favour) one = 0.25 + 1.5 * chance.next();
        const auto number = static_cast<std::size_t>(i);
        consider(growth.grown(kStrategies[number % std::size(kStrategies)], favour, kSizes[number % sizes] * whole));
    }
    return best;
}

}  // namespace tactics
