// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/folded_objects.h"

#include <algorithm>

#include "tactics/geometry/region_place.h"
#include "tactics/solid/named_part.h"
#include "tactics/solid/shown_twice.h"

namespace tactics {

namespace {

void count(FoldedObject& told, Handling handling) {
    switch (handling) {
        case Handling::kept: ++told.kept; break;
        case Handling::straightened: ++told.straightened; break;
        case Handling::folded: ++told.folded; break;
        case Handling::lying: ++told.lying; break;
        case Handling::flattened: ++told.flattened; break;
        case Handling::wedge: ++told.wedges; break;
    }
}

std::string_view shape_of(const ModelPart& part) {
    if (!part.round) return {};
    if (part.round->is_vessel()) return "vessel";
    switch (part.round->primitive) {
        case Primitive::cylinder: return "cylinder";
        case Primitive::cone: return "cone";
        case Primitive::sphere: return "sphere";
        default: return "turned";
    }
}

// One for each object that has parts, with its position in the list.
std::vector<FoldedObject> all_of(const Model& model, const std::vector<ModelPart>& parts, const std::vector<char>& is_small,
                                 std::vector<std::size_t>& place) {
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::vector<FoldedObject> objects;
    place.assign(model.objects.size(), kNone);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::uint32_t object = parts[i].object;
        if (place[object] == kNone) {
            place[object] = objects.size();
            FoldedObject& fresh = objects.emplace_back();
            fresh.object = object;
            fresh.path = path_of(model, object);
            fresh.name = spoken_name(model, object);
            fresh.fate = FoldedObject::Fate::hidden;
        }
        FoldedObject& one = objects[place[object]];
        one.form = parts[i].form;
        if (one.shape != "vessel") one.shape = shape_of(parts[i]);
        one.size = std::max(one.size, extent_of(parts[i]));
        if (is_small[i] != 0) one.fate = FoldedObject::Fate::small;
    }
    return objects;
}

}  // namespace

Phrase called(const FoldedObject& one) { return one.name.empty() ? phrase("part without a name") : Phrase(one.name); }

std::vector<FoldedObject> folded_objects(const Model& model, const std::vector<ModelPart>& parts,
                                         const std::vector<char>& is_small, const std::vector<ModelPart>& felt,
                                         const Panels& panels, const FlatLayout& layout, const IntoDrawing& into) {
    std::vector<std::size_t> place;
    std::vector<FoldedObject> objects = all_of(model, parts, is_small, place);
    const auto take = [&](std::uint32_t part, const auto& where) -> FoldedObject& {
        FoldedObject& one = objects[place[felt[part].object]];
        if (one.fate != FoldedObject::Fate::drawn) one.at = into.of(where());
        one.fate = FoldedObject::Fate::drawn;
        return one;
    };
    std::vector<char> laid(panels.panels.size(), 0), stands_for(felt.size(), 0);
    for (const PlacedPanel& placed : layout.panels) {
        laid[placed.panel] = 1;
        const Panel& panel = panels.panels[placed.panel];
        const auto where = [&] {
            Region shape;
            shape.rings = placed.shape.rings;
            return place_in(shape);
        };
        FoldedObject& one = take(panel.part, where);
        if (const auto& round = felt[panel.part].round; round && round->is_vessel()) {
            if (panel.kind == PanelKind::section) one.at = into.of(where());
            if (panel.kind == PanelKind::opening) one.opening = into.of(where());
            if (panel.kind == PanelKind::bottom) one.bottom = into.of(where());
        }
        if (panel.kind == PanelKind::hanging) {
            stands_for[panel.part] = 1;
            ++one.hanging;
        } else {
            count(one, placed.handling);
        }
    }
    for (const PlacedBar& bar : layout.bars) {
        if (panels.bars[bar.bar].is_edge) stands_for[panels.bars[bar.bar].part] = 1;
        FoldedObject& one = take(panels.bars[bar.bar].part, [&] {
            return Point{(bar.from.x + bar.to.x) / 2, (bar.from.y + bar.to.y) / 2};
        });
        if (bar.handling == Handling::wedge &&
            one.kept + one.folded + one.straightened + one.lying + one.flattened + one.wedges == 0)
            one.at = in_wedge(one.at);
        count(one, bar.handling);
    }
    for (const std::uint32_t hinge : shown_twice(layout, panels, touching_in(felt)))
        ++objects[place[felt[panels.panels[panels.hinges[hinge].one].part].object]].doubled;
    for (std::size_t i = 0; i < laid.size(); ++i) {
        const Panel& panel = panels.panels[i];
        if (laid[i] == 0 && panel.reached && (panel.kind == PanelKind::side || panel.kind == PanelKind::bottom) &&
            stands_for[panel.part] == 0)
            ++objects[place[felt[panel.part].object]].left_out;
    }
    return objects;
}

}  // namespace tactics
