// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/part.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "tactics/solid/coarse.h"
#include "tactics/solid/largest_first.h"
#include "tactics/solid/named_part.h"
#include "tactics/solid/ranks.h"
#include "tactics/solid/settled.h"
#include "tactics/solid/space_box.h"

namespace tactics {

namespace {

constexpr double kWeld = 1e-5;             // of a model's extent, as millimetres of a house are none
constexpr std::size_t kMostSides = 64;     // patches that a hand could tell one from the other; more are a curve
constexpr std::size_t kMostShells = 2000;  // pieces of an object; A4 has room for as many places that a finger can tell apart
constexpr double kSameSize = 1e-3;         // of two sizes, by which they may differ and be the same
constexpr double kSmallSide = 0.02;        // of the area, below which a patch is a facet of something curved

double extent_of(const Model& model) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    Point3 low{kNone, kNone, kNone}, high{-kNone, -kNone, -kNone};
    for (const Point3& at : model.vertices) {
        low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
    return model.vertices.empty() ? 0 : length_of(high - low);
}

// The directions of sides, those with the most area first, each perpendicular to those before. Upright if there are none.
std::array<Point3, 3> directions_of(const Solid& solid) {
    struct Lot {
        Point3 normal;
        double area;
    };
    std::vector<Lot> lots;
    double total = 0;
    for (const Patch& patch : solid.patches) {
        total += patch.area;
        const auto found = std::find_if(lots.begin(), lots.end(),
                                        [&](const Lot& lot) { return std::abs(dot(lot.normal, patch.normal)) > 0.9999; });
        if (found != lots.end())
            found->area += patch.area;
        else if (lots.size() < 256)
            lots.push_back({patch.normal, patch.area});
    }
    std::vector<double> areas;
    for (const Lot& lot : lots) areas.push_back(lot.area);
    const std::vector<std::size_t> order = largest_first(areas, kSameSize);
    if (lots.empty() || areas[order.front()] < 0.1 * total) return {Point3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Point3 first = lots[order.front()].normal;
    Point3 second;
    double best = 0;
    for (const std::size_t i : order)
        if (std::abs(dot(lots[i].normal, first)) < 0.02 && areas[i] > best * (1 + kSameSize)) {
            second = lots[i].normal;
            best = areas[i];
        }
    if (best == 0) {  // a prism without a right angle: along the longest side of
                      // its largest patch
        double longest = 0;
        const auto& ring = solid.patches.front().rings.front();
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point3 side = ring[(i + 1) % ring.size()] - ring[i];
            if (length_of(side) > longest * (1 + kSameSize)) {
                longest = length_of(side);
                second = side;
            }
        }
    }
    second = unit(second - dot(second, first) * first);
    return {first, second, cross(first, second)};
}

PartBox box_along(std::array<Point3, 3> axes, const Solid& solid) {
    PartBox box;
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const Patch& patch : solid.patches)
        for (const auto& ring : patch.rings)
            for (const Point3& point : ring)
                for (std::size_t i = 0; i < 3; ++i) {
                    low[i] = std::min(low[i], dot(point, axes[i]));
                    high[i] = std::max(high[i], dot(point, axes[i]));
                }
    const std::vector<std::size_t> order = largest_first({high[0] - low[0], high[1] - low[1], high[2] - low[2]}, kSameSize);
    for (std::size_t i = 0; i < 3; ++i) {
        box.middle = box.middle + ((low[i] + high[i]) / 2) * axes[i];
        box.axis[i] = axes[order[i]];
        box.half[i] = (high[order[i]] - low[order[i]]) / 2;
    }
    if (dot(cross(box.axis[0], box.axis[1]), box.axis[2]) < 0) box.axis[2] = -1 * box.axis[2];
    return box;
}

bool is_curved(const Solid& solid) {
    if (solid.patches.size() > kMostSides) return true;
    double total = 0, small = 0;
    for (const Patch& patch : solid.patches) total += patch.area;
    for (const Patch& patch : solid.patches) small += patch.area < kSmallSide * total ? patch.area : 0;
    return small > 0.5 * total;
}

// As broad as it is deep, and upright on its ends.
bool is_round(const ModelObject& object) {
    if (object.primitive != Primitive::cylinder && object.primitive != Primitive::cone && object.primitive != Primitive::sphere)
        return false;
    const PrimitiveFrame& frame = object.frame;
    const double a = length_of(frame.a), b = length_of(frame.b), c = length_of(frame.c);
    if (!(a > 0 && b > 0 && c > 0) || std::abs(a - b) > 0.01 * a) return false;
    if (object.primitive == Primitive::sphere) return std::abs(a - c) <= 0.01 * a;
    return std::abs(dot(frame.a, frame.c)) < 0.01 * a * c && std::abs(dot(frame.b, frame.c)) < 0.01 * b * c;
}

bool has_end(const Solid& solid, const Point3& normal) {
    return std::any_of(solid.patches.begin(), solid.patches.end(),
                       [&](const Patch& patch) { return dot(patch.normal, normal) > 0.999; });
}

std::optional<Revolution> revolution_in(const Solid& solid, const ModelObject& object) {
    if (!is_round(object)) return revolution_of(solid);
    const Point3 along = unit(object.frame.c);
    return revolution_of(object.primitive, object.frame, has_end(solid, -1 * along), has_end(solid, along));
}

PartForm form_of(const ModelPart& part, const PartWish& wish) {
    const auto& half = part.box.half;
    if (wish.simplify && half[1] <= wish.slender * half[0]) return PartForm::line;
    if (wish.simplify && half[2] <= wish.flat * half[1]) return PartForm::face;
    return is_curved(part.solid) ? PartForm::curved : PartForm::solid;
}

ModelPart part_of(Solid solid, const ModelObject& object, std::uint32_t place, const PartWish& wish) {
    ModelPart part;
    part.object = place;
    part.solid = std::move(solid);
    part.box = box_along(directions_of(part.solid), part.solid);
    part.form = form_of(part, wish);
    part.folds = wish.fold;
    if (part.form != PartForm::curved && part.form != PartForm::solid) return part;
    part.round = revolution_in(part.solid, object);
    if (part.round) part.form = PartForm::round;
    return part;
}

// Without seams, as it is not folded out.
void add_to(Solid& crowd, Solid solid) {
    crowd.closed = false;
    std::move(solid.patches.begin(), solid.patches.end(), std::back_inserter(crowd.patches));
}

// Those of one object by where they are, whatever the order of its faces.
void put_parts_in_order(std::vector<ModelPart>& parts, std::size_t first, double tolerance) {
    const double grain = 50 * tolerance;
    std::vector<Point3> middles, sizes;
    for (std::size_t i = first; i < parts.size(); ++i) {
        middles.push_back(parts[i].box.middle);
        sizes.push_back({parts[i].box.half[0], parts[i].box.half[1], parts[i].box.half[2]});
    }
    const auto where = ranks_of(middles, grain), large = ranks_of(sizes, grain);
    std::vector<std::size_t> order(middles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return where[a] != where[b] ? where[a] < where[b] : large[a] < large[b];
    });
    std::vector<ModelPart> sorted;
    for (const std::size_t i : order) sorted.push_back(std::move(parts[first + i]));
    std::move(sorted.begin(), sorted.end(), parts.begin() + static_cast<std::ptrdiff_t>(first));
}

// What is on something round and smaller, of the same object, is its handle or its spout.
void take_handles(std::vector<ModelPart>& parts, std::size_t first) {
    constexpr std::size_t kMostHandles = 8;
    constexpr double kSmaller = 0.4;  // of its surface
    constexpr double kNear = 0.05;    // of its extent
    const auto surface = [](const ModelPart& part) {
        double sum = 0;
        for (const Patch& patch : part.solid.patches) sum += patch.area;
        return sum;
    };
    for (std::size_t one = first; one < parts.size(); ++one) {
        std::size_t tried = 0;
        for (std::size_t other = first; other < parts.size() && parts[one].round && tried < kMostHandles; ++other) {
            const double reach = kNear * extent_of(parts[one]);
            if (other == one || parts[other].round || parts[one].round->primitive == Primitive::sphere ||
                surface(parts[other]) > kSmaller * surface(parts[one]) ||
                apart(space_of(parts[one]), space_of(parts[other])) > reach)
                continue;
            ++tried;
            Solid both = parts[one].solid;
            add_to(both, parts[other].solid);
            auto whole = revolution_of(both, *parts[one].round);
            if (!whole || !whole->has_handle()) continue;
            parts[one].box = box_along(directions_of(both), both);
            parts[one].solid = std::move(both);
            parts[one].round = std::move(whole);
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(other));
            if (other < one) --one;
            --other;
        }
    }
}

double distance_to_side(const Point3& at, const Point3& from, const Point3& to) {
    const Point3 along = to - from;
    const double length = dot(along, along);
    const double share = length > 0 ? std::clamp(dot(at - from, along) / length, 0.0, 1.0) : 0;
    return length_of(at - from - share * along);
}

std::vector<PartWish> wishes_of(const Model& model, const PartWish& wish, const std::vector<ObjectWish>& objects) {
    std::vector<PartWish> wishes(model.objects.size(), wish);
    for (const ObjectWish& one : objects) {
        bool fits = false;
        for (std::uint32_t i = 0; i < wishes.size(); ++i)
            for (int at = static_cast<int>(i); at >= 0; at = model.objects[static_cast<std::size_t>(at)].parent)
                if (is_named(model, static_cast<std::uint32_t>(at), one.path)) {
                    wishes[i] = one.parts;
                    fits = true;
                    break;
                }
        if (!fits) part_named(model, one.path);  // says which there are
    }
    return wishes;
}

}  // namespace

std::string_view name_of(PartForm form) {
    switch (form) {
        case PartForm::solid: return "solid";
        case PartForm::face: return "face";
        case PartForm::line: return "line";
        case PartForm::round: return "round";
        case PartForm::curved: return "curved";
    }
    return "";
}

std::vector<ModelPart> parts_of(const Model& whole, const PartWish& wish, const std::vector<ObjectWish>& objects,
                                std::vector<Phrase>& notes) {
    const bool has_many = corners_of(whole) > kMostWorkedCorners;
    const Model model = settled(has_many ? coarse(whole, notes) : whole);
    const double tolerance = kWeld * extent_of(model);
    const std::vector<PartWish> wishes = wishes_of(model, wish, objects);
    std::vector<ModelPart> parts;
    std::size_t dropped = 0;
    for (std::uint32_t place = 0; place < model.objects.size(); ++place) {
        const ModelObject& object = model.objects[place];
        if (wishes[place].hide) continue;
        std::vector<std::uint32_t> faces;
        for (std::uint32_t i = 0; i < object.count; ++i) faces.push_back(object.first + i);
        WeldedSurface surface = weld(model, faces, tolerance, dropped);
        const auto shells = shells_of(surface);
        const bool is_crowd = shells.size() > kMostShells;
        const std::size_t before = parts.size();
        Solid crowd;
        for (const auto& shell : shells) {
            face_outwards(surface, shell);
            Solid solid = solid_of(surface, shell);
            if (is_crowd)
                add_to(crowd, std::move(solid));
            else if (!solid.patches.empty())
                parts.push_back(part_of(std::move(solid), object, place, wishes[place]));
        }
        put_parts_in_order(parts, before, tolerance);
        take_handles(parts, before);
        if (crowd.patches.empty()) continue;
        parts.push_back(part_of(std::move(crowd), object, place, wishes[place]));
        parts.back().form = PartForm::curved;
        notes.push_back(object.name.empty()
                            ? phrase("an object is made of {0} pieces, too many to be told apart, and drawn by its outline",
                                     std::to_string(shells.size()))
                            : phrase("{0} is made of {1} pieces, too many to be told apart, and drawn by its outline",
                                     path_of(model, place), std::to_string(shells.size())));
    }
    if (dropped > 0)
        notes.push_back(phrases(dropped, "{0} face without area, or that was there twice, is left out",
                                "{0} faces without area, or that were there twice, are left out"));
    return parts;
}

Stretch stretch_of(const Solid& solid, const Point3& direction) {
    Stretch stretch{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Patch& patch : solid.patches)
        for (const auto& ring : patch.rings)
            for (const Point3& at : ring) {
                stretch.low = std::min(stretch.low, dot(at, direction));
                stretch.high = std::max(stretch.high, dot(at, direction));
            }
    return stretch;
}

double extent_of(const ModelPart& part) { return 2 * part.box.half[0]; }

std::array<Point3, 2> ends_of(const ModelPart& part) {
    const Point3 half = part.box.half[0] * part.box.axis[0];
    return {part.box.middle - half, part.box.middle + half};
}

double distance(const Point3& at, const ModelPart& part) {
    double least = std::numeric_limits<double>::infinity();
    bool inside = part.solid.closed;
    for (const Patch& patch : part.solid.patches) {
        const double off = dot(patch.normal, at - patch.rings.front().front());
        inside = inside && off <= 0;
        if (std::abs(off) >= least) continue;
        if (is_over(at - off * patch.normal, patch.normal, patch.rings)) least = std::abs(off);
        for (const auto& ring : patch.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                least = std::min(least, distance_to_side(at, ring[i], ring[(i + 1) % ring.size()]));
    }
    return inside ? 0 : least;
}

}  // namespace tactics
