// SPDX-License-Identifier: Apache-2.0
#include "filters/silhouette_worth.h"

#include <algorithm>
#include <cmath>

#include "filters/node_outlines.h"

namespace tactics {

namespace {

#include "filters/silhouette_weights.inc"

}  // namespace

std::vector<Silhouette> silhouettes_at(const RegionTree& tree, std::span<const float> chances, std::size_t face) {
    const std::vector<Bulk> bulks = bulks_of(tree, chances);
    std::vector<std::size_t> path, beside;
    for (std::size_t i = face; i + 1 < tree.nodes.size(); i = static_cast<std::size_t>(tree.nodes[i].parent)) {
        if (!is_thing(tree, i)) continue;
        path.push_back(i);
        const RegionNode& parent = tree.nodes[static_cast<std::size_t>(tree.nodes[i].parent)];
        const auto other =
            static_cast<std::size_t>(parent.children[0] == static_cast<int>(i) ? parent.children[1] : parent.children[0]);
        beside.push_back(other);
        for (const int c : tree.nodes[other].children)
            if (c >= 0 && is_thing(tree, static_cast<std::size_t>(c))) beside.push_back(static_cast<std::size_t>(c));
    }
    std::vector<Silhouette> things;
    for (const std::size_t i : path) things.push_back({i, -1, bulks[i]});
    for (const Silhouette& pair : pairs_of(tree, chances, bulks, path, beside)) things.push_back(pair);
    return things;
}

SilhouetteFeatures features_of(const RegionTree& tree, const Silhouette& thing, Point point) {
    const Bulk& e = thing.bulk;
    const double picture = static_cast<double>(tree.width) * tree.height;
    const double share = e.area / picture, frame = e.frame[0] + e.frame[1] + e.frame[2] + e.frame[3];
    const double around = std::max(e.outline + frame, 1.0);
    double sides = 0;
    for (std::size_t k = 0; k < 4; ++k) sides += e.frame[k] > 0 ? 1 : 0;
    const auto lasting = [&](std::size_t i) {
        return static_cast<double>(tree.nodes[static_cast<std::size_t>(tree.nodes[i].parent)].level - tree.nodes[i].level) / 255;
    };
    const double lasts = thing.other < 0 ? lasting(thing.node) : 0;
    const double wide = e.box.width(), high = e.box.height();
    const double off =
        std::hypot((point.x - (e.box.left + e.box.right) / 2) / wide, (point.y - (e.box.top + e.box.bottom) / 2) / high);
    const double size = std::log(share + 1e-4) / 5, sure = e.mean_chance();
    return {sure,
            sure * sure,
            lasts,
            thing.other < 0 ? 0.0 : 1.0,
            size,
            size * size,
            sides / 4,
            sides >= 3 ? 1.0 : 0.0,
            frame / around,
            std::sqrt(4 * 3.14159265358979 * e.area) / around,
            e.area / (wide * high),
            off,
            size * sure,
            1};
}

double worth_of(const RegionTree& tree, const Silhouette& thing, Point point) {
    const SilhouetteFeatures features = features_of(tree, thing, point);
    double sum = 0;
    for (std::size_t i = 0; i < kSilhouetteFeatures; ++i) sum += kSilhouetteWeights[i] * features[i];
    return sum;
}

}  // namespace tactics
