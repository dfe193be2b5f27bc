// SPDX-License-Identifier: Apache-2.0
#include "filters/outline_lines.h"

#include <algorithm>
#include <cmath>

#include "filters/paths.h"
#include "filters/pixel_graph.h"
#include "filters/region_arcs.h"

namespace tactics {

std::vector<Point> rounded(const std::vector<Point>& points, bool closed, double sigma) {
    const auto count = static_cast<std::ptrdiff_t>(points.size());
    std::vector<Point> result(points.size());
    const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3 * sigma));
    std::vector<double> weight(static_cast<std::size_t>(reach) + 1);
    for (std::ptrdiff_t k = 0; k <= reach; ++k)
        weight[static_cast<std::size_t>(k)] = std::exp(-static_cast<double>(k * k) / (2 * sigma * sigma));
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const std::ptrdiff_t most = closed ? std::min(reach, (count - 1) / 2) : std::min({reach, i, count - 1 - i});
        Point sum{points[static_cast<std::size_t>(i)]};
        double all = 1;
        for (std::ptrdiff_t k = 1; k <= most; ++k) {
            const double w = weight[static_cast<std::size_t>(k)];
            const Point &a = points[static_cast<std::size_t>((i + count - k) % count)],
                        &b = points[static_cast<std::size_t>((i + k) % count)];
            sum = {sum.x + w * (a.x + b.x), sum.y + w * (a.y + b.y)};
            all += 2 * w;
        }
        result[static_cast<std::size_t>(i)] = {sum.x / all, sum.y / all};
    }
    return result;
}

PixelChain chain_of(const RegionArc& arc, int kind) {
    PixelChain chain;
    chain.kind = kind;
    chain.closed = arc.closed;
    chain.from = arc.junctions[0];
    chain.to = arc.junctions[1];
    for (std::size_t i = 0; i + (arc.closed ? 0 : 1) < arc.points.size(); ++i) {
        const Point a = arc.points[i], b = arc.points[(i + 1) % arc.points.size()];
        chain.points.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
    }
    return chain;
}

namespace {

// The pixel that a point lies in; on the far sides of the picture the last one.
std::size_t pixel_at(Point p, int width, int height) {
    return std::min(static_cast<std::size_t>(p.y), static_cast<std::size_t>(height - 1)) * static_cast<std::size_t>(width) +
           std::min(static_cast<std::size_t>(p.x), static_cast<std::size_t>(width - 1));
}

}  // namespace

float mean_along(const std::vector<Point>& points, const std::vector<float>& pixels, int width, int height) {
    double sum = 0;
    for (const Point& p : points) sum += static_cast<double>(pixels[pixel_at(p, width, height)]);
    return static_cast<float>(sum / static_cast<double>(points.size()));
}

namespace {

// The middle lines of what is slender, as chains that end freely or at junctions of their own.
void add_slender(PixelGraph& graph, const InkMap& slender, int kind) {
    Skeleton skeleton = thin(slender);
    constexpr double kSpur = 6;
    PixelGraph lines = graph_of(skeleton, kSpur);
    const int before = static_cast<int>(graph.junctions.size());
    for (PixelJunction& junction : lines.junctions) graph.junctions.push_back(junction);
    for (PixelChain& chain : lines.chains) {
        if (chain.from >= 0) chain.from += before;
        if (chain.to >= 0) chain.to += before;
        chain.kind = kind;
        graph.chains.push_back(std::move(chain));
    }
}

// A line that ends on itself, as a 6 does, is a ring and a line that ends on it: both are easier to follow.
void part_rings(std::vector<PixelPath>& paths, const PixelGraph& graph) {
    const std::size_t count = paths.size();
    paths.reserve(3 * count);  // what is added must not move what is looked at
    for (std::size_t p = 0; p < count; ++p)
        for (const std::size_t side : {0u, 1u}) {
            PixelPath& path = paths[p];
            const int junction = path.ends_at[side];
            const auto passed = std::find(path.passes.begin(), path.passes.end(), junction);
            if (path.closed || junction < 0 || passed == path.passes.end()) continue;
            const Point at = graph.junctions[static_cast<std::size_t>(junction)].at;
            // The point of the line nearest to the junction, its ends aside.
            std::size_t nearest = 0;
            for (std::size_t i = 2; i + 2 < path.points.size(); ++i)
                if (nearest == 0 || distance(path.points[i], at) < distance(path.points[nearest], at)) nearest = i;
            if (nearest == 0) continue;
            const auto middle = path.points.begin() + static_cast<std::ptrdiff_t>(nearest);
            PixelPath ring;
            ring.kind = path.kind;
            ring.closed = true;
            ring.passes.push_back(junction);
            if (side == 0) {
                ring.points.assign(path.points.begin() + 1, middle + 1);
                ring.passes.insert(ring.passes.end(), path.passes.begin(), passed);
                path.points.erase(path.points.begin(), middle);
                path.passes.erase(path.passes.begin(), passed + 1);
            } else {
                ring.points.assign(middle, path.points.end() - 1);
                ring.passes.insert(ring.passes.end(), passed + 1, path.passes.end());
                path.points.erase(middle + 1, path.points.end());
                path.passes.erase(passed, path.passes.end());
            }
            if (ring.points.size() >= 3) paths.push_back(std::move(ring));
        }
    std::erase_if(paths, [](const PixelPath& path) { return path.points.size() < 2; });
}

constexpr int kSlenderKind = 100;  // a kind of line beside the classes

}  // namespace

Drawing lines_of_parts(const RoomyParts& parts, int width, int height, double mm_per_pixel, double bend,
                       const std::function<ArcInk(const RegionArc&)>& ink) {
    const PlanarMap map = planar_map_of(parts.part, width, height);
    PixelGraph graph;
    for (const Point junction : map.junctions) graph.junctions.push_back({junction, 0});
    std::vector<float> strength(parts.part.size(), 0.0f);  // of what is drawn through each pixel
    for (const RegionArc& arc : map.arcs) {
        const ArcInk drawn = ink(arc);
        if (!drawn.drawn) continue;
        graph.chains.push_back(chain_of(arc, static_cast<int>(drawn.line)));
        for (const Point p : graph.chains.back().points) strength[pixel_at(p, width, height)] = drawn.strength;
    }
    add_slender(graph, parts.slender, kSlenderKind);
    auto paths = join_at_junctions(graph);
    part_rings(paths, graph);
    reach_lines(paths, 4 * bend, width, height);
    Drawing drawing;
    drawing.width = width * mm_per_pixel;
    drawing.height = height * mm_per_pixel;
    std::vector<Stroke> strokes;
    for (PixelPath& path : paths) {
        Stroke stroke;
        stroke.closed = path.closed;
        stroke.line = path.kind == kSlenderKind ? LineClass::thin : static_cast<LineClass>(path.kind);
        stroke.strength = mean_along(path.points, strength, width, height);
        path.points = rounded(path.points, path.closed, bend);
        strokes.push_back(std::move(stroke));
    }
    attach_ends(paths, graph);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        for (Point& p : paths[i].points)
            strokes[i].points.push_back(
                {std::clamp(p.x * mm_per_pixel, 0.0, drawing.width), std::clamp(p.y * mm_per_pixel, 0.0, drawing.height)});
        drawing.strokes.push_back(std::move(strokes[i]));
    }
    return drawing;
}

}  // namespace tactics
