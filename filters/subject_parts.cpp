// SPDX-License-Identifier: Apache-2.0
#include "filters/subject_parts.h"

#include <algorithm>
#include <cmath>

#include "filters/subject.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kInner = 0.6;  // of the outline's length: more inside a thing, and its outline is no longer what is felt first
constexpr float kStays = 1, kNever = -10;  // as chances of arcs

bool parts_things(const NamedThings& things, const RegionArc& arc) {
    return things.of_face[arc.faces[0]] != things.of_face[arc.faces[1]];
}

bool inside_thing(const NamedThings& things, const RegionArc& arc) {
    return !parts_things(things, arc) && things.of_face[arc.faces[0]] != 0;
}

}  // namespace

bool NamedThings::any() const {
    return std::any_of(share.begin(), share.end(), [](double one) { return one > 0; });
}

NamedThings find_things(const RegionTree& tree, std::span<const float> chances, std::span<const Spot> spots) {
    NamedThings things{std::vector<std::uint32_t>(tree.faces(), 0), std::vector<double>(spots.size(), 0.0)};
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const std::vector<bool> faces = faces_of_subject(tree, chances, spots[i]);
        double area = 0;
        for (std::size_t f = 0; f < faces.size(); ++f) {
            if (!faces[f]) continue;
            area += tree.nodes[f].area;
            things.of_face[f] = static_cast<std::uint32_t>(i + 1);
        }
        things.share[i] = area / (static_cast<double>(tree.width) * tree.height);
    }
    return things;
}

std::string words_of(const NamedThings& things, std::span<const Spot> spots) {
    std::string text;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        if (i > 0) text += "; ";
        if (things.share[i] > 0)
            text += "found, " + to_text(std::max(1.0, std::round(100 * things.share[i]))) + " % of the picture";
        else if (spots[i].is_box())
            text += "no closed thing was found in " + to_text(spots[i]) + ": draw the box closer around it";
        else
            text += "no closed thing was found at " + to_text(spots[i]) + ": draw a box around it";
    }
    return text;
}

std::vector<bool> arcs_in(const RegionTree& tree, std::span<const Spot> boxes) {
    std::vector<bool> in(tree.arcs.size(), false);
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const RegionArc& arc = tree.arcs[i];
        for (const Spot& box : boxes) {
            const auto held = std::count_if(arc.points.begin(), arc.points.end(), [&](const Point& p) {
                return p.x >= box.left * tree.width && p.x <= box.right * tree.width && p.y >= box.top * tree.height &&
                       p.y <= box.bottom * tree.height;
            });
            if (2 * static_cast<std::size_t>(held) > arc.points.size()) in[i] = true;
        }
    }
    return in;
}

double room_inside(const RegionTree& tree, const Parts& parts, const NamedThings& things) {
    constexpr double kLines = 0.25;  // of the outline's length: a few, which a hand does not take for the thing's own shape
    double outlines = 0, inside = 0;
    for (const RegionArc& arc : tree.arcs) {
        if (parts_things(things, arc))
            outlines += steps_of(arc);
        else if (inside_thing(things, arc) && parts.divides(arc))
            inside += steps_of(arc);
    }
    return std::min(kInner * outlines - inside, kLines * outlines);
}

Parts parts_with_things(const RegionTree& tree, std::span<const float> chances, const NamedThings& things,
                        const ThingWishes& wishes) {
    const std::vector<bool> left_out = arcs_in(tree, wishes.leave);
    Parts parts{things.of_face};
    const double outlines = length_of(tree, parts);
    std::vector<float> inner(chances.begin(), chances.end()), outer = inner;
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const bool inside = inside_thing(things, tree.arcs[i]);
        if (parts_things(things, tree.arcs[i])) {
            inner[i] = outer[i] = kStays;
        } else if (!inside) {
            inner[i] = kNever;
            if (left_out[i]) outer[i] = kNever;
        }
    }
    if (outlines > 0) parts = more_parts(tree, std::move(parts), inner, wishes.price, (1 + kInner) * outlines);
    if (wishes.only && outlines > 0) return parts;
    for (std::size_t i = 0; i < tree.arcs.size(); ++i)
        if (inside_thing(things, tree.arcs[i])) outer[i] = parts.divides(tree.arcs[i]) ? kStays : kNever;
    return more_parts(tree, std::move(parts), outer, wishes.price, wishes.most);
}

}  // namespace tactics
