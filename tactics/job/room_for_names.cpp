// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/room_for_names.h"

#include <algorithm>
#include <array>

#include "tactics/error.h"
#include "tactics/layout/lay_out.h"

namespace tactics {

namespace {

// Costs for a hand, as settings: a key must be looked up, a lead line followed; a drawing smaller by a tenth is less bad than one
// lead line.
constexpr double kLeftOut = 6, kKeyed = 3, kLed = 1.5, kTenthSmaller = 1;
constexpr std::array<double, 5> kShares{1, 0.9, 0.8, 0.7, 0.6};

double cost_of(const Page& page, double share) {
    const auto keyed =
        std::count_if(page.names.begin(), page.names.end(), [](const PageName& name) { return !name.key.empty(); });
    const auto led = std::count_if(page.strokes.begin(), page.strokes.end(),
                                   [](const PageStroke& stroke) { return stroke.role == Role::lead; });
    return kLeftOut * static_cast<double>(page.left_out.size()) + kKeyed * static_cast<double>(keyed) +
           kLed * static_cast<double>(led) + kTenthSmaller * 10 * (1 - share);
}

}  // namespace

std::optional<RoomFound> width_with_room(const Sheet& sheet, double widest, double aspect, const DrawOnSheet& draw) {
    std::optional<RoomFound> best;
    double least = 0;
    for (const double share : kShares) {
        if (best && kTenthSmaller * 10 * (1 - share) >= least) break;  // no smaller one can be better
        Sheet narrower = sheet;
        if (share < 1) narrower.drawing_width = share * widest;
        try {
            Arrangement arrangement = arrange(narrower, aspect);
            const Drawing drawing = draw(narrower, arrangement);
            const Page page = lay_out(drawing, narrower, std::move(arrangement));
            const double cost = cost_of(page, share);
            if (best && cost >= least) continue;
            best = {share * widest, page.left_out.size()};
            least = cost;
        } catch (const Error&) {
            continue;  // no room for some name: a smaller drawing leaves more
        }
    }
    return best;
}

}  // namespace tactics
