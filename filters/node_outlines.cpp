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

std::size_t meeting_of(const RegionTree& tree, std::size_t a, std::size_t b) {
    while (a != b) {
        std::size_t& lower = a < b ? a : b;  // a parent comes after its children
        lower = static_cast<std::size_t>(tree.nodes[lower].parent);
    }
    return a;
}

FaceOrder::FaceOrder(const RegionTree& tree) : first(tree.nodes.size(), 0), count(tree.nodes.size(), 1), face_at(tree.faces()) {
    for (std::size_t i = tree.faces(); i < tree.nodes.size(); ++i)
        count[i] = count[static_cast<std::size_t>(tree.nodes[i].children[0])] +
                   count[static_cast<std::size_t>(tree.nodes[i].children[1])];
    for (std::size_t i = tree.nodes.size(); i-- > tree.faces();) {
        const auto a = static_cast<std::size_t>(tree.nodes[i].children[0]),
                   b = static_cast<std::size_t>(tree.nodes[i].children[1]);
        first[a] = first[i];
        first[b] = first[i] + count[a];
    }
    for (std::uint32_t f = 0; f < tree.faces(); ++f) face_at[first[f]] = f;
}

}  // namespace tactics
