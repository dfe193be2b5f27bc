// SPDX-License-Identifier: Apache-2.0
#include "filters/node_outlines.h"

namespace tactics {

std::vector<std::vector<std::uint32_t>> outlines_of_nodes(const RegionTree& tree) {
    std::vector<std::vector<std::uint32_t>> outline(tree.nodes.size());
    for (std::uint32_t i = 0; i < tree.arcs.size(); ++i)
        for (const std::uint32_t face : tree.arcs[i].faces) outline[face].push_back(i);
    // What two children share is within their parent.
    std::vector<std::uint8_t> times(tree.arcs.size(), 0);
    for (std::size_t n = tree.faces(); n < tree.nodes.size(); ++n) {
        const auto each_arc = [&](const auto& visit) {
            for (const int child : tree.nodes[n].children)
                for (const std::uint32_t arc : outline[static_cast<std::size_t>(child)]) visit(arc);
        };
        each_arc([&](std::uint32_t arc) { ++times[arc]; });
        each_arc([&](std::uint32_t arc) {
            if (times[arc] == 1) outline[n].push_back(arc);
            times[arc] = 0;
        });
    }
    return outline;
}

bool is_thing(const RegionTree& tree, std::size_t node) {
    const int parent = tree.nodes[node].parent;
    return parent >= 0 && tree.nodes[static_cast<std::size_t>(parent)].level > 0;
}

}  // namespace tactics
