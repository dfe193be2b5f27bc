// SPDX-License-Identifier: Apache-2.0
#include "tactics/region_tree.h"

#include <algorithm>

namespace tactics {

namespace {

// The largest node of no higher level that holds each node.
std::vector<std::size_t> tops_at(const RegionTree& tree, float level) {
    std::vector<std::size_t> top(tree.nodes.size());
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const int parent = tree.nodes[i].parent;
        const bool merged = parent >= 0 && tree.nodes[static_cast<std::size_t>(parent)].level <= level;
        top[i] = merged ? top[static_cast<std::size_t>(parent)] : i;
    }
    return top;
}

}  // namespace

std::vector<std::uint32_t> regions_at(const RegionTree& tree, float level) {
    const std::vector<std::size_t> top = tops_at(tree, level);
    constexpr std::uint32_t kNone = 0xffffffff;
    std::vector<std::uint32_t> number(tree.nodes.size(), kNone), region(tree.face.size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < region.size(); ++i) {
        std::uint32_t& n = number[top[tree.face[i]]];
        if (n == kNone) n = count++;
        region[i] = n;
    }
    return region;
}

double steps_of(const RegionArc& arc) { return static_cast<double>(arc.points.size()) - (arc.closed ? 0 : 1); }

EdgeMap levels_of(const RegionTree& tree) {
    EdgeMap map;
    map.width = tree.width;
    map.height = tree.height;
    map.mm_per_pixel = tree.mm_per_pixel;
    map.thinned = true;
    map.strength.assign(tree.face.size(), 0.0f);
    for (const RegionArc& arc : tree.arcs)
        for_each_side(arc, [&](int x, int y) {
            float& strength =
                map.strength[static_cast<std::size_t>(y) * static_cast<std::size_t>(tree.width) + static_cast<std::size_t>(x)];
            strength = std::max(strength, arc.level);
        });
    return map;
}

}  // namespace tactics
