// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/fold_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tactics/error.h"
#include "tactics/solid/drawn_lines.h"
#include "tactics/solid/named_part.h"
#include "tactics/solid/spread.h"

namespace tactics {

namespace {

constexpr int kMostScales = 4;           // what is hidden depends on the scale, and the scale on what is hidden
constexpr double kAboveIsAsGood = 0.15;  // of the rating: people look at things from above
constexpr double kSpreads[] = {1.25, 1.6, 2};
constexpr double kWorthMoving = 0.05;  // of the rating that the moved layout must be better by
constexpr double kMoving = 0.05;       // of the rating that it costs to be twice as far apart
constexpr double kWedgeLength = 6,
                 kWedgeWidth = 3;  // mm: an arrow that a finger tells from a dot

struct Laid {
    FlatLayout layout;
    Panels panels;
    std::vector<std::uint32_t> thing;
    double spread = 1;
};

ViewPlane plane_of(FoldPlane plane) {
    switch (plane) {
        case FoldPlane::front: return kFromTheFront;
        case FoldPlane::side: return {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
        default: return kFromAbove;
    }
}

struct Extent {
    Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    void take(Point at) {
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    double width() const { return high.x - low.x; }
    double height() const { return high.y - low.y; }
};

Extent extent_of(const FlatLayout& layout) {
    Extent extent;
    for (const PlacedPanel& panel : layout.panels)
        for (const auto& ring : panel.shape.rings)
            for (const Point& at : ring) extent.take(at);
    for (const PlacedBar& bar : layout.bars) {
        extent.take(bar.from);
        extent.take(bar.to);
    }
    return extent;
}

double scale_for(const Extent& extent, double width, double height, double edge) {
    const double wide = std::max(extent.width(), 1e-9), high = std::max(extent.height(), 1e-9);
    return std::min((width - 2 * edge) / wide, (height - 2 * edge) / high);
}

Laid lay(const Model& model, const std::vector<ModelPart>& parts, FoldPlane plane, double gap, const FoldWish& wish) {
    const ViewPlane view = plane_of(plane);
    const std::vector<std::uint32_t> thing = things_of(model, parts);
    LayoutWish layout{wish.reader, gap, wish.effort};
    Laid best{{}, panels_of(parts, thing, view, wish.reach), thing};
    best.layout = lay_flat(parts, best.panels, thing, view, layout);
    // Where all is shown already there is nothing to be won.
    if (!wish.move || best.layout.rating.shown > 1 - kWorthMoving) return best;
    const double value = best.layout.rating.value();
    for (const double spread : kSpreads) {
        const std::vector<ModelPart> moved = spread_out(parts, thing, view, spread);
        if (moved.empty()) break;
        Laid other{{}, panels_of(moved, thing, view, wish.reach), thing, spread};
        // What a hand reaches is a matter of where things are in truth.
        for (std::size_t i = 0; i < other.panels.panels.size(); ++i)
            other.panels.panels[i].reached = best.panels.panels[i].reached;
        other.layout = lay_flat(moved, other.panels, thing, view, layout);
        other.layout.rating.asked += kMoving * std::log2(spread);
        if (other.layout.rating.value() > std::max(value + kWorthMoving, best.layout.rating.value() + 1e-9))
            best = std::move(other);
    }
    return best;
}

Area wedge_at(Point at) {
    return {{{{at.x - kWedgeWidth / 2, at.y}, {at.x + kWedgeWidth / 2, at.y}, {at.x, at.y + kWedgeLength}}}, Role::symbol, 0};
}

// A place well within a shape: of some on a grid, the one farthest from its
// border.
Point place_in(const FlatShape& shape) {
    Point best = shape.rings.front().front();
    double farthest = -1;
    constexpr int kSteps = 12;
    for (int i = 1; i < kSteps; ++i)
        for (int j = 1; j < kSteps; ++j) {
            const Point at{shape.low.x + (shape.high.x - shape.low.x) * i / kSteps,
                           shape.low.y + (shape.high.y - shape.low.y) * j / kSteps};
            if (!holds(shape, at)) continue;
            const double off = distance_to_border(shape, at);
            if (off > farthest * (1 + 1e-6)) {
                farthest = off;
                best = at;
            }
        }
    return best;
}

// From the layout, which has y upwards, into the drawing.
struct IntoDrawing {
    double scale, left, top, edge;
    Point of(Point at) const { return {edge + (at.x - left) * scale, edge + (top - at.y) * scale}; }
};

void tell_object(FoldedObject& told, const Panel& panel, const PlacedPanel& placed, const IntoDrawing& into) {
    switch (placed.handling) {
        case Handling::straightened: ++told.straightened; break;
        case Handling::folded: ++told.folded; break;
        case Handling::lying: ++told.lying; break;
        default: ++told.kept; break;
    }
    if (told.outline.empty() || placed.handling == Handling::kept) {
        if (told.outline.empty()) told.at = into.of(place_in(placed.shape));
    }
    (void)panel;
    for (const auto& ring : placed.shape.rings) {
        told.outline.emplace_back();
        for (const Point& at : ring) told.outline.back().push_back(into.of(at));
    }
}

}  // namespace

std::string_view name_of(FoldPlane plane) {
    switch (plane) {
        case FoldPlane::automatic: return "auto";
        case FoldPlane::above: return "above";
        case FoldPlane::front: return "front";
        case FoldPlane::side: return "side";
    }
    return "";
}

FoldOut fold_out(const Model& whole, double width, double height, const Medium& medium, const FoldWish& wish,
                 std::vector<std::string>& notes) {
    const Model model = wish.part.empty() ? whole : part_named(whole, wish.part);
    const std::vector<ModelPart> parts = parts_of(model, wish.parts, wish.objects, notes);
    if (parts.empty()) throw Error(Fault::failed, "the model", "it has no faces with an area, and nothing to draw");
    const double between = least_apart(medium, medium.line, medium.line), edge = medium.thick_line / 2;
    std::vector<char> is_small(parts.size(), 0);
    FoldOut made;
    Laid laid;
    std::vector<ModelPart> felt;
    std::vector<std::size_t> place;  // of each felt part among all
    double scale = 0;
    for (int round = 0; round < kMostScales; ++round) {
        felt.clear();
        place.clear();
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (is_small[i] == 0) {
                felt.push_back(parts[i]);
                place.push_back(i);
            }
        const double gap = scale > 0 ? between / scale : 0;
        FoldWish first = wish;
        if (scale == 0) first.effort = std::min(wish.effort, 4);
        if (made.plane == FoldPlane::above && round == 0 && wish.plane == FoldPlane::automatic) {
            laid = lay(model, felt, FoldPlane::above, gap, first);
            Laid front = lay(model, felt, FoldPlane::front, gap, first);
            if (front.layout.rating.value() > laid.layout.rating.value() + kAboveIsAsGood) {
                made.plane = FoldPlane::front;
                laid = std::move(front);
            }
        } else {
            if (wish.plane != FoldPlane::automatic) made.plane = wish.plane;
            laid = lay(model, felt, made.plane, gap, first);
        }
        const double before = scale;
        scale = scale_for(extent_of(laid.layout), width, height, edge);
        bool changed = before == 0 || std::abs(scale - before) > 0.02 * scale;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const bool small = extent_of(parts[i]) * scale < medium.shortest && felt.size() > 1;
            if (small && is_small[i] == 0) {
                is_small[i] = 1;
                changed = true;
            }
        }
        if (std::all_of(is_small.begin(), is_small.end(), [](char one) { return one != 0; })) {
            is_small.assign(parts.size(), 0);  // nothing would be left
            changed = false;
        }
        if (!changed) break;
    }
    const Extent extent = extent_of(laid.layout);
    const IntoDrawing into{scale, extent.low.x, extent.high.y, edge};
    made.scale = scale;
    made.spread = laid.spread;
    made.rating = laid.layout.rating;
    Drawing& drawing = made.drawing;
    drawing.width = extent.width() * scale + 2 * edge;
    drawing.height = extent.height() * scale + 2 * edge;
    for (Stroke& stroke : lines_of(laid.layout, felt, laid.panels, laid.thing)) {
        for (Point& at : stroke.points) at = into.of(at);
        drawing.strokes.push_back(std::move(stroke));
    }
    // What became of each object.
    std::vector<int> told(model.objects.size(), -1);
    const auto object_of = [&](std::uint32_t object) -> FoldedObject& {
        if (told[object] < 0) {
            told[object] = static_cast<int>(made.objects.size());
            FoldedObject one;
            one.object = object;
            one.path = path_of(model, object);
            one.name = spoken_name(model, object);
            one.fate = FoldedObject::Fate::hidden;
            made.objects.push_back(std::move(one));
        }
        return made.objects[static_cast<std::size_t>(told[object])];
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        FoldedObject& one = object_of(parts[i].object);
        one.form = parts[i].form;
        one.size = std::max(one.size, tactics::extent_of(parts[i]));
        if (is_small[i] != 0 && one.fate == FoldedObject::Fate::hidden) one.fate = FoldedObject::Fate::small;
    }
    std::vector<char> laid_panels(laid.panels.panels.size(), 0);
    for (const PlacedPanel& placed : laid.layout.panels) {
        const Panel& panel = laid.panels.panels[placed.panel];
        laid_panels[placed.panel] = 1;
        FoldedObject& one = object_of(felt[panel.part].object);
        one.fate = FoldedObject::Fate::drawn;
        tell_object(one, panel, placed, into);
    }
    for (std::size_t i = 0; i < laid_panels.size(); ++i)
        if (laid_panels[i] == 0 && laid.panels.panels[i].reached && laid.panels.panels[i].kind == PanelKind::side)
            ++object_of(felt[laid.panels.panels[i].part].object).left_out;
    for (const PlacedBar& bar : laid.layout.bars) {
        FoldedObject& one = object_of(felt[laid.panels.bars[bar.bar].part].object);
        one.fate = FoldedObject::Fate::drawn;
        const Point from = into.of(bar.from), to = into.of(bar.to);
        if (one.outline.empty()) one.at = {(from.x + to.x) / 2, (from.y + to.y) / 2};
        if (bar.handling == Handling::wedge) {
            drawing.areas.push_back(wedge_at(from));
            ++one.wedges;
        } else {
            ++(bar.handling == Handling::flattened ? one.flattened : one.kept);
        }
        one.outline.push_back({from, to});
    }
    for (const FoldedObject& one : made.objects)
        if (one.fate == FoldedObject::Fate::drawn && !one.name.empty())
            drawing.names.push_back({.at = one.at, .text = one.name, .origin = "the model", .within = 0, .optional = true});
    return made;
}

}  // namespace tactics
