// SPDX-License-Identifier: Apache-2.0
#include "filters/subject.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "filters/min_cut.h"
#include "filters/node_outlines.h"
#include "filters/silhouette_worth.h"
#include "filters/silhouettes.h"

namespace tactics {

namespace {

// Chosen on every second of the validation photographs of BSDS500; the overlap with what people agree on changes by 0.02 when one
// of them is halved or doubled.
constexpr double kAlikeBlur = 8;     // CIELAB: colours so near are alike
constexpr double kColours = 0.5;     // how much colours count beside the vote
constexpr double kFit = 15;          // a candidate's vote is e to the power of this times how well its box fits
constexpr double kSure = 15;         // and of this times the mean chance of its outline
constexpr double kPull = 18;         // what is known of the faces, against the length of the outline
constexpr double kCrisp = 4.5;       // an outline costs its length times e to the power of minus this times its chance
constexpr double kInside = 0.75;     // less of a face in the box, and it is ground
constexpr double kLeastFit = 0.3;    // the box of what is found must agree with the box around it so much
constexpr double kLeastSure = 0.08;  // mean chance of an outline that is one
constexpr std::size_t kPaired = 24;  // nodes that are tried in pairs
constexpr int kSubjectRounds = 3;    // in which the colours inside are those of what was found

// What a person drew around the thing.
struct Bounds {
    Box box;                     // in pixels
    std::vector<double> inside;  // share of each face
};

Bounds bounds_of(const RegionTree& tree, const Spot& spot) {
    Bounds bounds{{spot.left * tree.width, spot.top * tree.height, spot.right * tree.width, spot.bottom * tree.height},
                  std::vector<double>(tree.faces(), 0.0)};
    for (int y = 0; y < tree.height; ++y)
        for (int x = 0; x < tree.width; ++x)
            if (x + 0.5 > bounds.box.left && x + 0.5 < bounds.box.right && y + 0.5 > bounds.box.top &&
                y + 0.5 < bounds.box.bottom)
                bounds.inside[tree.face[static_cast<std::size_t>(y) * static_cast<std::size_t>(tree.width) +
                                        static_cast<std::size_t>(x)]] += 1;
    for (std::size_t f = 0; f < tree.faces(); ++f) bounds.inside[f] /= std::max(tree.nodes[f].area, 1.0);
    return bounds;
}

std::size_t find_top(const RegionTree& tree) { return tree.nodes.size() - 1; }

// How well each node and the pairs of the best fit the box, the best first.
struct Ranked {
    Silhouette thing;
    double fit = 0;
};

std::vector<Ranked> ranked_by_box(const RegionTree& tree, std::span<const float> chances, const Box& box) {
    const std::vector<Bulk> bulks = bulks_of(tree, chances);
    std::vector<Ranked> ranked;
    for (std::size_t i = 0; i < find_top(tree); ++i)
        if (is_thing(tree, i)) ranked.push_back({{i, -1, bulks[i]}, overlap_of_boxes(bulks[i].box, box)});
    const auto better = [](const Ranked& a, const Ranked& b) {
        return a.fit + a.thing.bulk.mean_chance() > b.fit + b.thing.bulk.mean_chance();
    };
    std::stable_sort(ranked.begin(), ranked.end(), better);
    std::vector<std::size_t> best;
    for (std::size_t i = 0; i < std::min(kPaired, ranked.size()); ++i) best.push_back(ranked[i].thing.node);
    for (Silhouette& pair : pairs_of(tree, chances, bulks, best, best)) {
        if (static_cast<std::size_t>(pair.other) < pair.node) continue;
        const double fit = overlap_of_boxes(pair.bulk.box, box);
        ranked.push_back({pair, fit});
    }
    return ranked;
}

// The share of the votes that each face has.
std::vector<double> votes_of(const RegionTree& tree, const std::vector<Ranked>& ranked) {
    std::vector<double> of_node(tree.nodes.size(), 0.0);
    double all = 0;
    for (const Ranked& r : ranked) {
        const double weight = std::exp(kFit * r.fit + kSure * r.thing.bulk.mean_chance());
        all += weight;
        of_node[r.thing.node] += weight;
        if (r.thing.other >= 0) of_node[static_cast<std::size_t>(r.thing.other)] += weight;
    }
    for (std::size_t i = tree.nodes.size() - 1; i-- > 0;) of_node[i] += of_node[static_cast<std::size_t>(tree.nodes[i].parent)];
    of_node.resize(tree.faces());
    for (double& vote : of_node) vote /= std::max(all, 1e-12);
    return of_node;
}

// How much more likely each face's colour is of what counts as `thing` than of the rest.
std::vector<double> colour_odds(const RegionTree& tree, const std::vector<double>& thing) {
    const std::size_t faces = tree.faces();
    double all_in = 0, all_out = 0;
    for (std::size_t f = 0; f < faces; ++f) {
        all_in += tree.nodes[f].area * thing[f];
        all_out += tree.nodes[f].area * (1 - thing[f]);
    }
    std::vector<double> share(faces, 0.5);
    if (all_in <= 0 || all_out <= 0) return share;
    for (std::size_t f = 0; f < faces; ++f) {
        double in = 1e-4, out = 1e-4;
        for (std::size_t g = 0; g < faces; ++g) {
            double d = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double one = static_cast<double>(tree.nodes[f].colour[c]) - static_cast<double>(tree.nodes[g].colour[c]);
                d += one * one;
            }
            if (d > 12 * kAlikeBlur * kAlikeBlur) continue;
            const double near = std::exp(-d / (2 * kAlikeBlur * kAlikeBlur)) * tree.nodes[g].area;
            in += near * thing[g] / all_in;
            out += near * (1 - thing[g]) / all_out;
        }
        share[f] = in / (in + out);
    }
    return share;
}

std::vector<bool> cut_out(const RegionTree& tree, std::span<const float> chances, const Bounds& bounds,
                          const std::vector<double>& likely) {
    constexpr double kUnits = 1024;  // of whole numbers, so that every machine cuts alike
    const double side = std::sqrt(bounds.box.width() * bounds.box.height());
    double most = 0;
    for (const RegionArc& arc : tree.arcs) most += steps_of(arc);
    std::vector<std::int64_t> as_thing(tree.faces()), as_ground(tree.faces());
    for (std::size_t f = 0; f < tree.faces(); ++f) {
        const double pull = kPull * tree.nodes[f].area / std::max(side, 1.0), p = std::clamp(likely[f], 0.01, 0.99);
        const bool outside = bounds.inside[f] < kInside;
        as_thing[f] = std::llround(kUnits * (outside ? most : -pull * std::log(p)));
        as_ground[f] = outside ? 0 : std::llround(-kUnits * pull * std::log(1 - p));
    }
    std::vector<CutEdge> edges;
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const RegionArc& arc = tree.arcs[i];
        // What is too small to be felt stays with what it was merged with.
        const double cost = arc.level > 0 ? steps_of(arc) * std::exp(-kCrisp * static_cast<double>(chances[i])) : most;
        edges.push_back({arc.faces[0], arc.faces[1], std::llround(kUnits * cost)});
    }
    return min_cut(as_thing, as_ground, edges);
}

bool any(const std::vector<bool>& faces) { return std::find(faces.begin(), faces.end(), true) != faces.end(); }

// Its outline is one that people would see.
bool is_seen(const RegionTree& tree, std::span<const float> chances, const std::vector<bool>& faces) {
    double length = 0, sure = 0;
    for (std::size_t i = 0; i < tree.arcs.size(); ++i)
        if (faces[tree.arcs[i].faces[0]] != faces[tree.arcs[i].faces[1]]) {
            length += steps_of(tree.arcs[i]);
            sure += steps_of(tree.arcs[i]) * static_cast<double>(chances[i]);
        }
    return length > 0 && sure >= kLeastSure * length;
}

std::vector<bool> in_box(const RegionTree& tree, std::span<const float> chances, const Spot& spot) {
    const Bounds bounds = bounds_of(tree, spot);
    const std::vector<Ranked> ranked = ranked_by_box(tree, chances, bounds.box);
    const std::vector<double> votes = votes_of(tree, ranked);
    std::vector<double> thing = bounds.inside;
    std::vector<bool> found(tree.faces(), false);
    for (int round = 0; round < kSubjectRounds; ++round) {
        std::vector<double> likely = colour_odds(tree, thing);
        for (std::size_t f = 0; f < likely.size(); ++f) likely[f] = kColours * likely[f] + (1 - kColours) * votes[f];
        found = cut_out(tree, chances, bounds, likely);
        if (!any(found)) break;
        for (std::size_t f = 0; f < likely.size(); ++f) thing[f] = found[f] ? 1 : 0;
    }
    if (any(found)) return found;
    const auto best = std::max_element(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
        return a.fit + a.thing.bulk.mean_chance() < b.fit + b.thing.bulk.mean_chance();
    });
    if (best == ranked.end() || best->fit < kLeastFit) return found;
    return faces_in(tree, best->thing);
}

std::vector<bool> at_point(const RegionTree& tree, std::span<const float> chances, const Spot& spot) {
    const auto pixel = [](double share, int size) {
        return static_cast<std::size_t>(std::clamp(static_cast<int>(share * size), 0, size - 1));
    };
    const std::size_t face =
        tree.face[pixel(spot.top, tree.height) * static_cast<std::size_t>(tree.width) + pixel(spot.left, tree.width)];
    const std::vector<Silhouette> things = silhouettes_at(tree, chances, face);
    std::optional<std::size_t> best;
    double most = 0;
    for (std::size_t i = 0; i < things.size(); ++i)
        if (const double worth = worth_of(tree, things[i], {spot.left * tree.width, spot.top * tree.height});
            !best || worth > most) {
            best = i;
            most = worth;
        }
    return best ? faces_in(tree, things[*best]) : std::vector<bool>(tree.faces(), false);
}

}  // namespace

std::vector<bool> faces_of_subject(const RegionTree& tree, std::span<const float> chances, const Spot& spot) {
    std::vector<bool> faces = spot.is_box() ? in_box(tree, chances, spot) : at_point(tree, chances, spot);
    if (any(faces) && !is_seen(tree, chances, faces)) faces.assign(tree.faces(), false);
    return faces;
}

}  // namespace tactics
