// SPDX-License-Identifier: Apache-2.0
#include "filters/traced.h"

#include <algorithm>

#include "filters/dots.h"
#include "filters/edge_map.h"
#include "filters/middle.h"
#include "filters/paths.h"
#include "filters/smooth.h"
#include "filters/spacing.h"

namespace tactics {

namespace {

float mean_strength(const std::vector<Point>& points, const EdgeMap& edges) {
    double sum = 0;
    for (const Point& p : points)
        sum += static_cast<double>(edges.strength[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(edges.width) +
                                                  static_cast<std::size_t>(p.x)]);
    return points.empty() ? 0.0f : static_cast<float>(sum / static_cast<double>(points.size()));
}

// In mm. Smoothing, and an end that is led on to a line, may overshoot the picture; the drawing ends with it.
Point placed(Point p, double scale, const Drawing& drawing) {
    return {std::clamp(p.x * scale, 0.0, drawing.width), std::clamp(p.y * scale, 0.0, drawing.height)};
}

std::uint32_t middle_pixel(const PixelPath& path, const Skeleton& skeleton) {
    const Point p = path.points[path.points.size() / 2];
    return skeleton.pixel_at(static_cast<int>(p.x), static_cast<int>(p.y));
}

// Pieces of ink that are wider than they are long are dots. Their paths are taken out; gives a pixel of each.
std::vector<std::uint32_t> dots_among(std::vector<PixelPath>& paths, const Skeleton& skeleton) {
    std::vector<std::uint32_t> dots;
    for (const std::uint32_t pixel : skeleton.pixels)
        if (neighbours_of(skeleton.map.bytes.data() + pixel, skeleton.map.stride) == 0 && skeleton.was_wider(pixel))
            dots.push_back(pixel);
    std::erase_if(paths, [&](const PixelPath& path) {
        if (path.closed || !path.free[0] || !path.free[1]) return false;
        const std::uint32_t pixel = middle_pixel(path, skeleton);
        if (static_cast<double>(path.points.size()) >= 2 * skeleton.half_width(pixel)) return false;
        dots.push_back(pixel);
        return true;
    });
    return dots;
}

}  // namespace

void add_area(Drawing& drawing, const Outline& outline, double scale, double shortest) {
    if (outline.rings.empty() || outline.rings.front().extent * scale < shortest) return;
    Area area;
    for (const OutlineRing& ring : outline.rings) {
        if (ring.extent * scale < shortest) continue;  // a hole no finger would find is filled
        auto points = smooth(ring.points, true);
        keep_area(points, ring.area);
        for (Point& p : points) p = placed(p, scale, drawing);
        area.rings.push_back(std::move(points));
    }
    drawing.areas.push_back(std::move(area));
}

void add_lines(Drawing& drawing, InkMap ink, const EdgeMap* edges, const EdgeMap* unthinned, double scale,
               const TraceLimits& limits) {
    const int width = ink.width, height = ink.height;
    Skeleton skeleton = thin(std::move(ink));
    const PixelGraph graph = graph_of(skeleton, limits.spur / scale);
    auto paths = join_at_junctions(graph);
    std::vector<std::uint32_t> dots;
    if (edges == nullptr) dots = dots_among(paths, skeleton);
    bridge(paths, limits.bridge / scale);
    reach_lines(paths, limits.bridge / scale, width, height);
    std::vector<float> strengths;
    for (PixelPath& path : paths) {
        strengths.push_back(edges != nullptr ? mean_strength(path.points, *edges) : 0.0f);
        if (unthinned != nullptr) {
            for (Point& p : path.points) p = on_ridge(*unthinned, p);
        } else {
            move_to_middle(path, skeleton);
        }
        path.points = smooth(path.points, path.closed);
    }
    attach_ends(paths, graph);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Stroke stroke{std::move(paths[i].points), paths[i].closed, LineClass::normal, strengths[i]};
        for (Point& p : stroke.points) p = placed(p, scale, drawing);
        const bool between = paths[i].ends_at[0] >= 0 && paths[i].ends_at[1] >= 0;
        if (length_of(stroke) >= (between ? kShareBetween : 1) * limits.shortest) drawing.strokes.push_back(std::move(stroke));
    }
    for (const std::uint32_t dot : dots) add_area(drawing, take_piece(skeleton, dot), scale, limits.shortest);
}

}  // namespace tactics
