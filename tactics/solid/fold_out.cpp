// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/fold_out.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"
#include "tactics/geometry/box.h"
#include "tactics/solid/drawn_lines.h"
#include "tactics/solid/folded_objects.h"
#include "tactics/solid/lay_flat.h"
#include "tactics/solid/moved_off.h"
#include "tactics/solid/named_part.h"
#include "tactics/solid/object_regions.h"
#include "tactics/solid/panels.h"
#include "tactics/solid/rated.h"
#include "tactics/solid/reach.h"
#include "tactics/solid/spread.h"
#include "tactics/solid/thing.h"

namespace tactics {

namespace {

constexpr int kMostScales = 4;          // what is hidden depends on the scale, and the scale on what is hidden
constexpr double kAboveIsAsGood = 0.1;  // of the rating: people look at things from above
constexpr double kSpreads[] = {1.25, 1.6, 2};
constexpr double kWorthMoving = 0.05;    // of the rating that the moved layout must be better by
constexpr double kSameScale = 0.02;      // of the scale, within which it is the same
constexpr double kMoving = 0.05;         // of the rating that it costs to be twice as far apart
constexpr std::size_t kMostNames = 100;  // six letters in braille with their gaps take 4 cm2, of which A4 has some 100 to spare

struct Laid {
    FlatLayout layout;
    Panels panels;
    std::vector<std::uint32_t> thing;
    std::vector<Point3> off = {};  // how far each part is moved off what was too close; empty: nothing was
    double spread = 1;
};

double edge_of(const Medium& medium) { return medium.thick_line / 2; }

double between_lines(const Medium& medium) { return least_apart(medium, medium.line, medium.line); }
// What stands on something has thick lines.
double between_things(const Medium& medium) { return least_apart(medium, medium.thick_line, medium.thick_line); }

// What a drawing has to fit. `lines`, `things`: mm of the model that must be between two lines, and between two things.
struct Fit {
    SheetRoom room;
    double shortest = 0, lines = 0, things = 0;
};

// `least`: of what has no extent in the plane, as a rod along the line of sight, how long it is in space.
double scale_for(const Box& box, double least, const SheetRoom& room) {
    if (std::max(box.width(), box.height()) < 1e-6 * least) return std::min(room.width, room.height) / least;
    return scale_in(room, box);
}

Laid lay(const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing, const ViewPlane& view, const Fit& fit,
         const FoldWish& wish) {
    const LayoutWish layout{wish.reader, fit.lines, wish.effort, fit.room, fit.shortest};
    const std::vector<Point3> off = wish.move ? moved_off(parts, thing, view, fit.things) : std::vector<Point3>{};
    const Panels panels = [&] {
        Panels made = panels_of(parts, thing, view);
        // A hand's reach depends on the true positions of things.
        find_reached(made, parts, wish.reach);
        return off.empty() ? made : moved(std::move(made), off);
    }();
    Laid best{lay_flat(parts, panels, thing, view, layout), panels, thing, off};
    // If everything is shown already, there is nothing to gain.
    if (!wish.move || best.layout.rating.shown > 1 - kWorthMoving) return best;
    const double value = best.layout.rating.value();
    for (const double spread : kSpreads) {
        const std::vector<Point3> by = spread_by(parts, thing, view, spread);
        if (by.empty()) break;
        Laid other{{}, moved(panels, by), thing, off, spread};
        other.layout = lay_flat(parts, other.panels, thing, view, layout);
        other.layout.rating.asked += kMoving * std::log2(spread);
        if (other.layout.rating.value() > std::max(value + kWorthMoving, best.layout.rating.value() + kAsGood))
            best = std::move(other);
    }
    return best;
}

Area wedge_at(Point at) {
    return {{{{at.x - kWedgeWide / 2, at.y}, {at.x + kWedgeWide / 2, at.y}, {at.x, at.y + kWedgeLong}}}, Role::symbol, 0};
}

struct Fitted {
    Laid laid;
    std::vector<ModelPart> felt;
    std::vector<char> is_small;  // of all parts
    ChosenPlane chosen;
    double scale = 0;  // 0: not known yet
};

void lay_felt(Fitted& fitted, const Model& model, const SheetRoom& room, const Medium& medium, const FoldWish& wish) {
    const std::vector<std::uint32_t> thing = things_of(model, fitted.felt);
    constexpr int kFirstEffort = 4;  // what is to be hidden is not known yet
    const bool first = fitted.scale == 0;
    // As wide yet at the scale that it leads to.
    const double of_model = first ? 0 : (1 + kSameScale) / fitted.scale;
    const Fit fit{room, medium.shortest, of_model * between_lines(medium), of_model * between_things(medium)};
    FoldWish now = wish;
    if (first) now.effort = std::min(wish.effort, kFirstEffort);
    // The plane stays what it was at first, so that what is hidden does not turn the drawing over.
    const std::vector<ChosenPlane> planes =
        first ? planes_for(wish.plane, fitted.felt, model.viewed_from) : std::vector<ChosenPlane>{fitted.chosen};
    double most = 0;
    for (const ChosenPlane& one : planes) {
        Laid laid = lay(fitted.felt, thing, one.view, fit, now);
        const double value = laid.layout.rating.value();
        const bool is_first = &one == &planes.front();
        if (!is_first && value <= most + kAsGood) continue;
        most = value + (is_first ? kAboveIsAsGood : 0);
        fitted.chosen = one;
        fitted.laid = std::move(laid);
    }
}

// Hides what is too small; true: there is more of it than before. Something always stays.
bool hide_small(Fitted& fitted, const std::vector<ModelPart>& parts, double least) {
    std::vector<char> small = fitted.is_small;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (extent_of(parts[i]) * fitted.scale < least) small[i] = 1;
    if (small == fitted.is_small || std::all_of(small.begin(), small.end(), [](char one) { return one != 0; })) return false;
    fitted.is_small = std::move(small);
    return true;
}

Fitted fitted_to(const SheetRoom& room, const Model& model, const std::vector<ModelPart>& parts, const Medium& medium,
                 const FoldWish& wish) {
    Fitted fitted;
    fitted.is_small.assign(parts.size(), 0);
    for (int round = 0; round < kMostScales; ++round) {
        fitted.felt.clear();
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (fitted.is_small[i] == 0) fitted.felt.push_back(parts[i]);
        lay_felt(fitted, model, room, medium, wish);
        const double before = fitted.scale;
        double longest = 0;
        for (const ModelPart& part : fitted.felt) longest = std::max(longest, extent_of(part));
        fitted.scale = scale_for(box_of(fitted.laid.layout), longest, room);
        const bool same = before > 0 && std::abs(fitted.scale - before) <= kSameScale * before;
        if (round + 1 == kMostScales || (!hide_small(fitted, parts, medium.shortest) && same)) break;
    }
    return fitted;
}

void tell_moved(std::vector<FoldedObject>& objects, const Fitted& fitted) {
    for (std::size_t part = 0; part < fitted.laid.off.size(); ++part)
        for (FoldedObject& one : objects)
            if (one.object == fitted.felt[part].object) one.moved = std::max(one.moved, length_of(fitted.laid.off[part]));
    const double least = touching_in(fitted.felt);
    for (FoldedObject& one : objects)
        if (one.moved <= least) one.moved = 0;
}

void tell_united(std::size_t count, std::vector<Phrase>& notes) {
    if (count == 0) return;
    notes.push_back(
        phrases(count, "{0} side is so close beside another that both are drawn as one line; draw a part alone to feel both",
                "{0} sides are so close beside others that they are drawn as one line with them; draw a part alone to feel all"));
}

std::vector<Name> names_of(const std::vector<FoldedObject>& objects, std::vector<Phrase>& notes) {
    std::vector<const FoldedObject*> named;
    for (const FoldedObject& one : objects)
        if (one.fate == FoldedObject::Fate::drawn && !one.name.empty()) named.push_back(&one);
    if (named.size() > kMostNames) {
        notes.push_back(phrase("only the {0} largest of {1} objects have their names on the page, which has no room for more",
                               std::to_string(kMostNames), std::to_string(named.size())));
        std::stable_sort(named.begin(), named.end(),
                         [](const FoldedObject* a, const FoldedObject* b) { return a->size > b->size; });
        named.resize(kMostNames);
        std::sort(named.begin(), named.end());  // as they stand in the list
    }
    std::vector<Name> names;
    for (const FoldedObject* one : named)
        names.push_back({.at = one->at, .text = one->name, .origin = "the model", .within = 0, .optional = true});
    return names;
}

// Of vessels with their opening and their bottom; where there are many, the line tells them apart.
void name_ends(std::vector<Name>& names, const std::vector<FoldedObject>& objects, const std::string& language) {
    constexpr std::ptrdiff_t kMostNamed = 3;
    if (std::count_if(objects.begin(), objects.end(), [](const FoldedObject& one) { return one.bottom || one.opening; }) >
        kMostNamed)
        return;
    const auto add = [&](Point at, const Phrase& text) {
        names.push_back({.at = at, .text = text.in(language), .origin = "the model", .within = 0, .optional = true});
    };
    for (const FoldedObject& one : objects) {
        if (one.opening && distance(*one.opening, one.at) > 0) add(*one.opening, phrase("opening"));
        if (one.bottom) add(*one.bottom, phrase("bottom"));
    }
}

}  // namespace

FoldOut fold_out(const Model& whole, double width, double height, const Medium& medium, const FoldWish& wish,
                 std::vector<Phrase>& notes) {
    const Model alone = wish.part.empty() ? Model{} : part_named(whole, wish.part);
    const Model& model = wish.part.empty() ? whole : alone;
    const std::vector<ModelPart> parts = parts_of(model, wish.parts, wish.objects, notes);
    if (parts.empty()) throw Error(Fault::failed, "the model", phrase("it has no faces with an area, and nothing to draw"));
    const double edge = edge_of(medium);
    const Fitted fitted = fitted_to({width - 2 * edge, height - 2 * edge, wish.turns}, model, parts, medium, wish);
    const Laid& laid = fitted.laid;
    const Box box = box_of(laid.layout);
    const IntoDrawing into{fitted.scale, box.left, box.top, edge};
    FoldOut made;
    made.plane = fitted.chosen.plane;
    made.up = model.up;
    made.scale = fitted.scale;
    made.spread = laid.spread;
    made.rating = laid.layout.rating;
    Drawing& drawing = made.drawing;
    drawing.width = box.width() * fitted.scale + 2 * edge;
    drawing.height = box.height() * fitted.scale + 2 * edge;
    const double apart = wish.unite ? between_lines(medium) / fitted.scale : 0;
    DrawnLines lines = lines_of(laid.layout, fitted.felt, laid.panels, laid.thing, medium.line / fitted.scale, apart);
    tell_united(lines.united, notes);
    for (Stroke& stroke : lines.strokes) {
        for (Point& at : stroke.points) at = into.of(at);
        drawing.strokes.push_back(std::move(stroke));
    }
    for (const PlacedBar& bar : laid.layout.bars)
        if (bar.handling == Handling::wedge) drawing.areas.push_back(wedge_at(into.of(bar.from)));
    made.objects = folded_objects(model, parts, fitted.is_small, fitted.felt, laid.panels, laid.layout, into);
    tell_moved(made.objects, fitted);
    drawing.names = names_of(made.objects, notes);
    name_ends(drawing.names, made.objects, wish.language);
    drawing.regions = object_regions(made.objects, fitted.felt, laid.panels, laid.layout, into, seen(made.plane));
    drawing.remarks = fold_remarks(drawing, made.objects, seen(made.plane), made.spread);
    return made;
}

}  // namespace tactics
