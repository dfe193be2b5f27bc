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

Box box_of(const FlatLayout& layout) {
    Box box = kNothing;
    for (const PlacedPanel& panel : layout.panels)
        for (const auto& ring : panel.shape.rings)
            for (const Point& at : ring) box.take(at);
    for (const PlacedBar& bar : layout.bars) {
        box.take(bar.from);
        box.take(bar.to);
    }
    return box;
}

double scale_in(const SheetRoom& room, const Box& box) {
    const double wide = std::max(box.width(), 1e-9), high = std::max(box.height(), 1e-9);
    const double upright = std::min(room.width / wide, room.height / high);
    return room.turns ? std::max(upright, std::min(room.height / wide, room.width / high)) : upright;
}

double touching_in(const std::vector<ModelPart>& parts) {
    constexpr double kTouching = 1e-4;  // of the largest part
    double extent = 0;
    for (const ModelPart& part : parts) extent = std::max(extent, extent_of(part));
    return kTouching * extent;
}

std::size_t most_outlines(PartForm form) { return form == PartForm::curved ? 2 : 1; }

}  // namespace tactics
