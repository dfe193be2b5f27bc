// SPDX-License-Identifier: Apache-2.0
#include "filters/region_tree_of.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/lab.h"
#include "filters/opencv.h"
#include "filters/region_arcs.h"
#include "filters/thin_things.h"
#include "filters/watershed.h"

namespace tactics {

namespace {

// The ridge of a map runs along the pixels on one side of a boundary or the other: the stronger of both, at each step.
std::vector<float> strengths_along(const RegionArc& arc, const EdgeMap& map) {
    const auto at = [&](double x, double y) {
        const int u = std::clamp(static_cast<int>(x), 0, map.width - 1), v = std::clamp(static_cast<int>(y), 0, map.height - 1);
        return map.strength[static_cast<std::size_t>(v) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(u)];
    };
    std::vector<float> strengths;
    for (std::size_t i = 0; i + (arc.closed ? 0 : 1) < arc.points.size(); ++i) {
        const Point a = arc.points[i], b = arc.points[(i + 1) % arc.points.size()];
        const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
        strengths.push_back(a.x == b.x ? std::max(at(x - 1, y), at(x, y)) : std::max(at(x, y - 1), at(x, y)));
    }
    return strengths;
}

float mean_of(const std::vector<float>& values) {
    double sum = 0;
    for (const float v : values) sum += static_cast<double>(v);
    return static_cast<float>(sum / static_cast<double>(values.size()));
}

// Pixels; a thin thing that is shorter is a grain. Else it is as long as two of the smallest regions.
constexpr double kShortest = 8;

#include "filters/pair_weights.inc"

Image in_colour(const Image& picture) {
    if (picture.channels == 3) return picture;
    Image colour = make_image(picture.width, picture.height, 3, picture.mm_per_pixel, 0);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        std::fill_n(colour.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, picture.pixels[i]);
    return colour;
}

// Grain of the picture is no texture of its things, and not twice the same in two copies.
std::vector<std::vector<float>> smoothed(std::vector<std::vector<float>> planes, int width, int height) {
    constexpr double kGrain = 1;  // pixels
    for (auto& plane : planes) {
        const cv::Mat view = view_of(plane, width, height);
        cv::GaussianBlur(view, view, cv::Size(), kGrain, kGrain, cv::BORDER_REFLECT);
    }
    return planes;
}

}  // namespace

const PairWeights& pair_weights(bool learned) { return learned ? kLearnedPairs : kPlainPairs; }

RegionTree region_tree_of(const Image& picture, const ContourMaps& maps, double least, const PairWeights& weights,
                          const PairWatcher& watcher) {
    return region_tree_on(basins_of(maps.fine), picture, maps, least, weights, watcher);
}

RegionTree region_tree_on(std::vector<std::uint32_t> face, const Image& picture, const ContourMaps& maps, double least,
                          const PairWeights& weights, const PairWatcher& watcher) {
    const EdgeMap& map = maps.fine;
    RegionTree tree;
    tree.width = map.width;
    tree.height = map.height;
    tree.inside = {0, 0, map.width, map.height};
    tree.mm_per_pixel = map.mm_per_pixel;
    tree.face = std::move(face);
    PlanarMap planar = planar_map_of(tree.face, tree.width, tree.height);
    tree.junctions = std::move(planar.junctions);
    tree.arcs = std::move(planar.arcs);
    for (RegionArc& arc : tree.arcs) {
        arc.coarse = mean_of(strengths_along(arc, maps.coarse));
        std::vector<float> strengths = strengths_along(arc, map);
        arc.strength = mean_of(strengths);
        const auto fifth = strengths.begin() + static_cast<std::ptrdiff_t>(strengths.size() / 5);
        std::nth_element(strengths.begin(), fifth, strengths.end());
        arc.weakest = *fifth;
    }
    const std::size_t faces = *std::max_element(tree.face.begin(), tree.face.end()) + 1u;
    auto planes = lab_planes(in_colour(picture));
    tree.lines = thin_things_of(tree, map, planes, std::max(2 * std::sqrt(least), kShortest));
    merge_regions(tree, sums_of(tree.face, faces, smoothed(std::move(planes), tree.width, tree.height), tree.width, tree.height),
                  least, weights, watcher);
    return tree;
}

}  // namespace tactics
