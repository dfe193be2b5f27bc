// SPDX-License-Identifier: Apache-2.0
#include "filters/inner_lines.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "filters/outline_lines.h"
#include "filters/paths.h"
#include "filters/pixel_graph.h"

namespace tactics {

namespace {

// Of its outline. A head on the shoulders has none at the frame, one that is cut off above a fifth; shoulders have a third and
// more.
constexpr double kAtFrame = 0.25;

}  // namespace

std::vector<bool> enclosed_faces(const RegionTree& tree, const Parts& parts) {
    const std::size_t count = *std::max_element(parts.part.begin(), parts.part.end()) + 1u;
    std::vector<double> border(count, 0), frame(count, 0);
    for (const RegionArc& arc : tree.arcs)
        if (parts.divides(arc))
            for (const std::uint32_t face : arc.faces) border[parts.part[face]] += steps_of(arc);
    const auto part_at = [&](int x, int y) {
        return parts
            .part[tree.face[static_cast<std::size_t>(y) * static_cast<std::size_t>(tree.width) + static_cast<std::size_t>(x)]];
    };
    for (int x = 0; x < tree.width; ++x)
        for (const int y : {0, tree.height - 1}) frame[part_at(x, y)] += 1;
    for (int y = 0; y < tree.height; ++y)
        for (const int x : {0, tree.width - 1}) frame[part_at(x, y)] += 1;
    std::vector<bool> enclosed;
    for (const std::uint32_t i : parts.part) enclosed.push_back(frame[i] < kAtFrame * (border[i] + frame[i]));
    return enclosed;
}

std::vector<RegionLine> inner_lines_of(const RegionTree& tree, const Parts& parts, const std::vector<bool>& within, float least) {
    PixelGraph graph;
    for (const Point junction : tree.junctions) graph.junctions.push_back({junction, 0});
    std::vector<float> strength(tree.face.size(), 0.0f);  // of the arc along the left or upper side of each pixel
    for (const RegionArc& arc : tree.arcs) {
        if (arc.strength < least || parts.divides(arc) || !within[arc.faces[0]] || !within[arc.faces[1]]) continue;
        graph.chains.push_back(chain_of(arc, 0));
        for_each_side(arc, [&](int x, int y) {
            strength[static_cast<std::size_t>(y) * static_cast<std::size_t>(tree.width) + static_cast<std::size_t>(x)] =
                arc.strength;
        });
    }
    std::vector<RegionLine> lines;
    for (PixelPath& path : join_at_junctions(graph)) {
        const float mean = mean_along(path.points, strength, tree.width, tree.height);
        lines.push_back({std::move(path.points), mean, {0, 0}});
    }
    return lines;
}

}  // namespace tactics
