// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/lay_flat.h"

#include <algorithm>
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
    const auto consider = [&](FlatLayout layout) {
        layout.rating = rating_of(layout, parts, panels, wish.reader);
        if (best.panels.empty() || layout.rating.value() > best.rating.value() + 1e-9) best = std::move(layout);
    };
    Growth growth(parts, panels, thing, view, wish);
    std::vector<double> favour(panels.panels.size(), 1);
    for (const Strategy strategy : kStrategies) consider(growth.grown(strategy, favour));
    Chance chance;
    const int tried = layouts_tried(wish.effort, panels.panels.size());
    for (int i = 0; i < tried; ++i) {
        for (double& one : favour) one = 0.25 + 1.5 * chance.next();
        consider(growth.grown(kStrategies[static_cast<std::size_t>(i) % std::size(kStrategies)], favour));
    }
    return best;
}

}  // namespace tactics
