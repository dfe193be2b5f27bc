// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/region_place.h"

#include <algorithm>

#include "tactics/geometry/box.h"
#include "tactics/geometry/course.h"

namespace tactics {

Point place_in(const Region& region) {
    constexpr int kSteps = 12;
    constexpr double kFarther = 1 + 1e-6;  // so that rounding does not choose
    const Box box = box_of(region);
    Point best = region.rings.front().front();
    double farthest = -1;
    for (int i = 1; i < kSteps; ++i)
        for (int j = 1; j < kSteps; ++j) {
            const Point at{box.left + box.width() * i / kSteps, box.top + box.height() * j / kSteps};
            if (!holds(region, at)) continue;
            double off = kNowhere;
            for (const auto& ring : region.rings)
                for (std::size_t k = 0; k < ring.size(); ++k)
                    off = std::min(off, distance_to_segment(at, ring[k], ring[(k + 1) % ring.size()]));
            if (off > farthest * kFarther) {
                farthest = off;
                best = at;
            }
        }
    return best;
}

}  // namespace tactics
