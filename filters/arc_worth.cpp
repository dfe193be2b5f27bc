// SPDX-License-Identifier: Apache-2.0
#include "filters/arc_worth.h"

#include <algorithm>
#include <cmath>

#include "filters/node_outlines.h"

namespace tactics {

namespace {

// The share of all boundary that has a higher value than each arc.
std::vector<float> rank_of(const std::vector<float>& value, const std::vector<double>& length) {
    std::vector<std::size_t> order;
    double all = 0;
    for (std::size_t i = 0; i < value.size(); ++i)
        if (value[i] > 0) {
            order.push_back(i);
            all += length[i];
        }
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return value[a] != value[b] ? value[a] > value[b] : a < b; });
    std::vector<float> rank(value.size(), 1.0f);
    double before = 0;
    for (const std::size_t i : order) {
        rank[i] = static_cast<float>(before / all);
        before += length[i];
    }
    return rank;
}

// Of all outlines that an arc is part of, the one that is surest along the whole of it.
struct Whole {
    float sureness = 0;
    float second = 0;  // of the next sure one, on the other side of the arc
    double area = 1;
    double length = 1;
};

std::vector<Whole> wholes_of(const RegionTree& tree, const std::vector<float>& strength, const std::vector<double>& length) {
    const auto outline = outlines_of_nodes(tree);
    std::vector<Whole> best(tree.arcs.size());
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
        const RegionNode& node = tree.nodes[n];
        if (!is_thing(tree, n)) continue;
        double sum = 0, all = 0;
        for (const std::uint32_t a : outline[n]) {
            sum += length[a] * std::sqrt(static_cast<double>(strength[a]));
            all += length[a];
        }
        const auto sureness = static_cast<float>(sum / std::max(all, 1.0));
        for (const std::uint32_t a : outline[n]) {
            if (sureness > best[a].sureness) {
                best[a].second = best[a].sureness;
                best[a].sureness = sureness;
                best[a].area = node.area;
                best[a].length = all;
            } else {
                best[a].second = std::max(best[a].second, sureness);
            }
        }
    }
    return best;
}

// How sure what goes on most nearly straight from each end of an arc is.
std::vector<std::array<float, 2>> onward_of(const RegionTree& tree, const std::vector<float>& strength) {
    constexpr std::size_t kBack = 8;  // steps that tell a direction
    struct End {
        std::size_t arc;
        std::size_t which;
        Point way;
    };
    std::vector<std::vector<End>> ends(tree.junctions.size());
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const RegionArc& arc = tree.arcs[i];
        if (arc.closed || strength[i] <= 0) continue;
        const std::size_t last = arc.points.size() - 1, back = std::min(kBack, last);
        for (std::size_t e = 0; e < 2; ++e) {
            const Point from = arc.points[e == 0 ? 0 : last], to = arc.points[e == 0 ? back : last - back];
            const double l = std::max(distance(from, to), 1e-9);
            ends[static_cast<std::size_t>(arc.junctions[e])].push_back({i, e, {(to.x - from.x) / l, (to.y - from.y) / l}});
        }
    }
    std::vector<std::array<float, 2>> onward(tree.arcs.size(), {0, 0});
    for (const auto& meeting : ends)
        for (const End& a : meeting)
            for (const End& b : meeting) {
                if (&a == &b) continue;
                const double straight = std::max(0.0, -(a.way.x * b.way.x + a.way.y * b.way.y));
                float& best = onward[a.arc][a.which];
                best = std::max(best, static_cast<float>(straight) * std::sqrt(strength[b.arc]));
            }
    return onward;
}

float log_share(double area, double of) { return static_cast<float>(std::log(std::max(area, 1.0) / of) / 5); }

// What is known of all arcs before each is looked at.
struct Known {
    std::vector<float> level, strength;  // 0 to 1; at level 0 there is no strength
    std::vector<double> length;
    std::vector<float> level_rank, strength_rank;
    std::vector<Whole> wholes;
    std::vector<std::array<float, 2>> onward;
};

Known known_of(const RegionTree& tree) {
    const std::size_t count = tree.arcs.size();
    Known known{std::vector<float>(count), std::vector<float>(count), std::vector<double>(count), {}, {}, {}, {}};
    for (std::size_t i = 0; i < count; ++i) {
        const RegionArc& arc = tree.arcs[i];
        known.level[i] = arc.level / 255;
        known.strength[i] = arc.level > 0 ? arc.strength / 255 : 0;
        known.length[i] = steps_of(arc);
    }
    known.level_rank = rank_of(known.level, known.length);
    known.strength_rank = rank_of(known.strength, known.length);
    known.wholes = wholes_of(tree, known.strength, known.length);
    known.onward = onward_of(tree, known.strength);
    return known;
}

// What became one when an arc vanished.
struct MergedOutline {
    double smaller = 0, both = 0;  // square pixels
    double filled = 0;             // by the smaller, of its box
    bool at_frame = false;         // the smaller is
    float apart = 0;               // from the last merging within either to this one, 0 to 1
};

MergedOutline merging_at(const RegionTree& tree, const RegionArc& arc) {
    const RegionNode& node = tree.nodes[meeting_of(tree, arc.faces[0], arc.faces[1])];
    const RegionNode& first = tree.nodes[static_cast<std::size_t>(node.children[0])];
    const RegionNode& second = tree.nodes[static_cast<std::size_t>(node.children[1])];
    const RegionNode& lesser = first.area < second.area ? first : second;
    const PixelBox& box = lesser.box;
    const double wide = box.width(), high = box.height();
    const bool at_frame = box.left == 0 || box.top == 0 || box.right == tree.width || box.bottom == tree.height;
    return {lesser.area, node.area, lesser.area / (wide * high), at_frame,
            node.level / 255 - std::max(first.level, second.level) / 255};
}

// Where the middle of an arc's corners is.
struct Whereabouts {
    double to_frame = 0;    // in sides of a square as large as the picture
    double off_middle = 0;  // in widths and heights of the picture
};

Whereabouts whereabouts_of(const RegionTree& tree, const RegionArc& arc) {
    double x = 0, y = 0;
    for (const Point& p : arc.points) {
        x += p.x;
        y += p.y;
    }
    x /= static_cast<double>(arc.points.size());
    y /= static_cast<double>(arc.points.size());
    const double off_x = x / tree.width - 0.5, off_y = y / tree.height - 0.5;
    const double side = std::sqrt(static_cast<double>(tree.width) * tree.height);
    return {std::min({x, y, tree.width - x, tree.height - y}) / side, std::sqrt(off_x * off_x + off_y * off_y)};
}

ArcFeatures features_of(const RegionTree& tree, const Known& known, std::size_t i) {
    const RegionArc& arc = tree.arcs[i];
    const MergedOutline merging = merging_at(tree, arc);
    const Whereabouts where = whereabouts_of(tree, arc);
    const Whole& whole = known.wholes[i];
    const std::array<float, 2>& onward = known.onward[i];
    const double picture = static_cast<double>(tree.width) * tree.height, side = std::sqrt(picture);
    return {known.level[i],
            std::sqrt(known.strength[i]),
            known.strength[i],
            known.level_rank[i],
            known.strength_rank[i],
            static_cast<float>(std::log(known.length[i] / side)) / 3,
            arc.unlike[0],
            arc.unlike[1],
            arc.unlike[2],
            log_share(merging.smaller, picture),
            log_share(merging.both, picture),
            static_cast<float>(merging.filled),
            merging.at_frame ? 1.0f : 0.0f,
            static_cast<float>(std::min(where.to_frame * 8, 1.0)),
            static_cast<float>(2 * where.off_middle),
            merging.apart,
            whole.sureness,
            whole.second,
            log_share(whole.area, picture),
            static_cast<float>(std::log(whole.length / side)) / 3,
            std::max(onward[0], onward[1]),
            arc.closed ? std::sqrt(known.strength[i]) : std::min(onward[0], onward[1]),
            std::sqrt(arc.coarse / 255),
            std::sqrt(arc.weakest / 255)};
}

}  // namespace

std::vector<ArcFeatures> arc_features_of(const RegionTree& tree) {
    const Known known = known_of(tree);
    std::vector<ArcFeatures> all(tree.arcs.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        if (tree.arcs[i].level > 0) all[i] = features_of(tree, known, i);
    return all;
}

namespace {

// A layer of few rectified sums and two sums of those, each with its constant last.
constexpr std::size_t kHidden = 48;
struct ArcWeights {
    float first[kHidden][kArcFeatures + 1];
    float drawn[kHidden + 1];
    float main[kHidden + 1];
};

using Hidden = std::array<float, kHidden>;

Hidden hidden_of(const ArcWeights& weights, const ArcFeatures& features) {
    Hidden hidden;
    for (std::size_t h = 0; h < kHidden; ++h) {
        float sum = weights.first[h][kArcFeatures];
        for (std::size_t f = 0; f < kArcFeatures; ++f) sum += weights.first[h][f] * features[f];
        hidden[h] = std::max(sum, 0.0f);
    }
    return hidden;
}

float chance_of(const float (&weights)[kHidden + 1], const Hidden& hidden) {
    float logit = weights[kHidden];
    for (std::size_t h = 0; h < kHidden; ++h) logit += weights[h] * hidden[h];
    return 1 / (1 + std::exp(-logit));
}

#include "filters/arc_weights.inc"

}  // namespace

ArcChances arc_chances_of(const RegionTree& tree) {
    const std::vector<ArcFeatures> features = arc_features_of(tree);
    ArcChances chances{std::vector<float>(features.size(), 0.0f), std::vector<float>(features.size(), 0.0f)};
    const ArcWeights& weights = tree.learned ? kLearnedArcs : kPlainArcs;
    for (std::size_t i = 0; i < features.size(); ++i) {
        if (tree.arcs[i].level <= 0) continue;
        const Hidden hidden = hidden_of(weights, features[i]);
        chances.drawn[i] = chance_of(weights.drawn, hidden);
        chances.main[i] = chance_of(weights.main, hidden);
    }
    return chances;
}

}  // namespace tactics
