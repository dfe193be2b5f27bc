// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/layout.h"

#include <algorithm>

namespace tactics {

std::string_view name_of(Handling handling) {
    switch (handling) {
        case Handling::kept: return "kept";
        case Handling::straightened: return "straightened";
        case Handling::folded: return "folded";
        case Handling::lying: return "lying";
        case Handling::flattened: return "flattened";
        case Handling::wedge: return "wedge";
    }
    return "";
}

Point Placement::of(const Point3& place) const {
    const double u = dot(place - origin, along), v = dot(place - origin, across);
    return {at.x + u * to_along.x + v * to_across.x, at.y + u * to_along.y + v * to_across.y};
}

double touching_in(const std::vector<ModelPart>& parts) {
    constexpr double kTouching = 1e-4;  // of the largest part
    double extent = 0;
    for (const ModelPart& part : parts) extent = std::max(extent, extent_of(part));
    return kTouching * extent;
}

std::size_t most_outlines(PartForm form) { return form == PartForm::curved ? 2 : 1; }

}  // namespace tactics
