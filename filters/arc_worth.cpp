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

}  // namespace

std::vector<ArcFeatures> arc_features_of(const RegionTree& tree) {
    const std::size_t count = tree.arcs.size();
    std::vector<float> level(count), strength(count);
    std::vector<double> length(count);
    for (std::size_t i = 0; i < count; ++i) {
        const RegionArc& arc = tree.arcs[i];
        level[i] = arc.level / 255;
        strength[i] = arc.level > 0 ? arc.strength / 255 : 0;
        length[i] = steps_of(arc);
    }
    const std::vector<float> level_rank = rank_of(level, length), strength_rank = rank_of(strength, length);
    const std::vector<Whole> wholes = wholes_of(tree, strength, length);
    const auto onward = onward_of(tree, strength);
    const double picture = static_cast<double>(tree.width) * tree.height, side = std::sqrt(picture);
    std::vector<ArcFeatures> all(count);
    for (std::size_t i = 0; i < count; ++i) {
        const RegionArc& arc = tree.arcs[i];
        if (arc.level <= 0) continue;
        const RegionNode& node = tree.nodes[meeting_of(tree, arc.faces[0], arc.faces[1])];
        const RegionNode& first = tree.nodes[static_cast<std::size_t>(node.children[0])];
        const RegionNode& second = tree.nodes[static_cast<std::size_t>(node.children[1])];
        const double smaller = std::min(first.area, second.area);
        const RegionNode& lesser = first.area < second.area ? first : second;
        const double wide = lesser.box[2] - lesser.box[0], high = lesser.box[3] - lesser.box[1];
        const bool at_frame =
            lesser.box[0] == 0 || lesser.box[1] == 0 || lesser.box[2] == tree.width || lesser.box[3] == tree.height;
        double x = 0, y = 0;
        for (const Point& p : arc.points) {
            x += p.x;
            y += p.y;
        }
        x /= static_cast<double>(arc.points.size());
        y /= static_cast<double>(arc.points.size());
        const double off_x = x / tree.width - 0.5, off_y = y / tree.height - 0.5;
        const double to_frame = std::min({x, y, tree.width - x, tree.height - y}) / side;
        const float apart = node.level / 255 - std::max(first.level, second.level) / 255;
        all[i] = {level[i],
                  std::sqrt(strength[i]),
                  strength[i],
                  level_rank[i],
                  strength_rank[i],
                  static_cast<float>(std::log(length[i] / side)) / 3,
                  arc.unlike[0],
                  arc.unlike[1],
                  arc.unlike[2],
                  log_share(smaller, picture),
                  log_share(node.area, picture),
                  static_cast<float>(lesser.area / (wide * high)),
                  at_frame ? 1.0f : 0.0f,
                  static_cast<float>(std::min(to_frame * 8, 1.0)),
                  static_cast<float>(2 * std::sqrt(off_x * off_x + off_y * off_y)),
                  apart,
                  wholes[i].sureness,
                  wholes[i].second,
                  log_share(wholes[i].area, picture),
                  static_cast<float>(std::log(wholes[i].length / side)) / 3,
                  std::max(onward[i][0], onward[i][1]),
                  arc.closed ? std::sqrt(strength[i]) : std::min(onward[i][0], onward[i][1]),
                  std::sqrt(arc.coarse / 255),
                  std::sqrt(arc.weakest / 255)};
    }
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
