// SPDX-License-Identifier: Apache-2.0
#include "filters/subject_parts.h"

#include <algorithm>
#include <cmath>

#include "filters/subject.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kInner = 0.6;  // of the outline's length: more inside a thing, and its outline is no longer what is felt first
constexpr float kStays = 1, kNever = -10;  // as worths of arcs

bool parts_things(const NamedThings& things, const RegionArc& arc) {
    return things.of_face[arc.faces[0]] != things.of_face[arc.faces[1]];
}

// A box around the whole picture leaves no ground that a thing could stand out from.
bool is_everything(const Spot& spot) {
    constexpr double kEdge = 0.01;
    return spot.is_box() && spot.left <= kEdge && spot.top <= kEdge && spot.right >= 1 - kEdge && spot.bottom >= 1 - kEdge;
}

bool inside_thing(const NamedThings& things, const RegionArc& arc) {
    return !parts_things(things, arc) && things.of_face[arc.faces[0]] != 0;
}

}  // namespace

bool NamedThings::any() const { return std::find(found.begin(), found.end(), true) != found.end(); }

NamedThings find_things(const RegionTree& tree, std::span<const float> chances, std::span<const Spot> spots) {
    NamedThings things{std::vector<std::uint32_t>(tree.faces(), 0), std::vector<double>(spots.size(), 0.0),
                       std::vector<bool>(spots.size(), false)};
    for (std::size_t i = 0; i < spots.size(); ++i) {
        if (is_everything(spots[i])) continue;
        const std::vector<bool> faces = faces_of_subject(tree, chances, spots[i]);
        for (std::size_t f = 0; f < faces.size(); ++f) {
            if (!faces[f]) continue;
            things.found[i] = true;
            things.of_face[f] = static_cast<std::uint32_t>(i + 1);
        }
    }
    for (std::size_t f = 0; f < things.of_face.size(); ++f)
        if (const std::uint32_t thing = things.of_face[f]; thing > 0)
            things.share[thing - 1] += tree.nodes[f].area / (static_cast<double>(tree.width) * tree.height);
    return things;
}

Phrase words_of(const NamedThings& things, std::span<const Spot> spots) {
    Phrase text;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const std::string spot = to_text(spots[i]);
        Phrase one;
        if (things.share[i] > 0)
            one = phrase("found, {0} % of the picture", numeral(std::max(1.0, std::round(100 * things.share[i]))));
        else if (things.found[i])
            one = phrase("what was found at {0} is part of what a later place names", spot);
        else if (is_everything(spots[i]))
            one = phrase("{0} is all of the picture and names nothing in it: draw the box closely around the thing", spot);
        else if (spots[i].is_box())
            one = phrase("no closed thing was found in {0}: draw the box closely around all of it", spot);
        else
            one = phrase("no closed thing was found at {0}: draw a box around it", spot);
        text = i == 0 ? std::move(one) : phrase("{0}; {1}", std::move(text), std::move(one));
    }
    return text;
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

Parts parts_with_things(const RegionTree& tree, std::span<const float> chances, double price, const NamedThings& things,
                        bool only, double line) {
    Parts parts{things.of_face};
    std::vector<float> inner(chances.begin(), chances.end()), outer = inner;
    for (std::size_t i = 0; i < tree.arcs.size(); ++i)
        if (parts_things(things, tree.arcs[i]))
            inner[i] = outer[i] = kStays;
        else if (!inside_thing(things, tree.arcs[i]))
            inner[i] = kNever;
    const double outlines = length_of(tree, parts);
    parts = more_parts(tree, std::move(parts), inner, price, (1 + kInner) * outlines);
    if (only) return parts;
    for (std::size_t i = 0; i < tree.arcs.size(); ++i)
        if (inside_thing(things, tree.arcs[i])) outer[i] = parts.divides(tree.arcs[i]) ? kStays : kNever;
    return parts_of_page(tree, outer, price, line, parts);
}

}  // namespace tactics
