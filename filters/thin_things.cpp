// SPDX-License-Identifier: Apache-2.0
#include "filters/thin_things.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "filters/contour_maps.h"
#include "filters/outline_lines.h"
#include "filters/paths.h"
#include "filters/pixel_graph.h"

namespace tactics {

namespace {

using Colour = std::array<float, 3>;

// Pixels of a scene of 480: a map of contours has one ridge for what is no wider than some 5 of them, and there is ground beyond.
constexpr int kMiddle = 2, kBeside = 4, kBeyond = 6;
// Steps over which colours are averaged along a line: grain and leaves are not thin things.
constexpr double kAlong = 2;
// CIELAB: four just noticeable differences (2.3: M. Mahy, L. Van Eycken, A. Oosterlinck, Color Research and Application 19,
// 1994).
constexpr float kDiffers = 10;
// A border differs from one side only, and its sides from each other.
constexpr float kMoreThanSides = 1.5f;
constexpr float kSameWay = 0.7f;  // cosine
// Of the neighbourhood of a step; a mast has a flag here and a bright cloud behind it there.
constexpr double kMostly = 0.6;
// The weakest arc that is looked at, of 255.
constexpr float kWeakest = 100;

float dot(const Colour& a, const Colour& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Colour less(const Colour& a, const Colour& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
float size_of(const Colour& a) { return std::sqrt(dot(a, a)); }

class Profiles {
public:
    Profiles(const std::vector<std::vector<float>>& lab, int width, int height) : lab_(lab), width_(width), height_(height) {}

    // Whether the picture is thin across each step of a line.
    std::vector<bool> thin_steps(const std::vector<Point>& line) const {
        const double unit = std::max(std::max(width_, height_) / kSceneSide, 0.3);
        std::vector<std::array<Colour, 2 * kBeyond + 1>> across(line.size());
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Point from = line[i > 3 ? i - 3 : 0], to = line[std::min(i + 3, line.size() - 1)];
            const double long_way = std::max(distance(from, to), 1e-9);
            const Point normal{-(to.y - from.y) / long_way * unit, (to.x - from.x) / long_way * unit};
            for (int k = -kBeyond; k <= kBeyond; ++k)
                across[i][static_cast<std::size_t>(k + kBeyond)] = at(line[i].x + k * normal.x, line[i].y + k * normal.y);
        }
        std::vector<bool> thin(line.size());
        for (std::size_t i = 0; i < line.size(); ++i) thin[i] = is_thin(averaged(across, i));
        return thin;
    }

private:
    Colour at(double x, double y) const {
        const double u = std::clamp(x - 0.5, 0.0, width_ - 1.001), v = std::clamp(y - 0.5, 0.0, height_ - 1.001);
        const auto column = static_cast<std::size_t>(u), row = static_cast<std::size_t>(v),
                   wide = static_cast<std::size_t>(width_);
        const auto right = static_cast<float>(u - static_cast<double>(column)),
                   down = static_cast<float>(v - static_cast<double>(row));
        const std::size_t i = row * wide + column, next = width_ > 1 ? 1 : 0, below = height_ > 1 ? wide : 0;
        Colour colour{};
        for (std::size_t c = 0; c < 3; ++c) {
            const std::vector<float>& p = lab_[c];
            colour[c] = (p[i] * (1 - right) + p[i + next] * right) * (1 - down) +
                        (p[i + below] * (1 - right) + p[i + below + next] * right) * down;
        }
        return colour;
    }

    template <typename Profile>
    static Profile averaged(const std::vector<Profile>& across, std::size_t i) {
        const auto reach = static_cast<std::size_t>(2 * kAlong);
        Profile mean{};
        float all = 0;
        for (std::size_t j = i > reach ? i - reach : 0; j < std::min(i + reach + 1, across.size()); ++j) {
            const double off = (static_cast<double>(j) - static_cast<double>(i)) / kAlong;
            const auto weight = static_cast<float>(std::exp(-off * off / 2));
            all += weight;
            for (std::size_t k = 0; k < mean.size(); ++k)
                for (std::size_t c = 0; c < 3; ++c) mean[k][c] += weight * across[j][k][c];
        }
        for (auto& colour : mean)
            for (float& value : colour) value /= all;
        return mean;
    }

    static bool is_thin(const std::array<Colour, 2 * kBeyond + 1>& across) {
        Colour left{}, right{};
        for (int k = kBeside; k <= kBeyond; ++k)
            for (std::size_t c = 0; c < 3; ++c) {
                left[c] += across[static_cast<std::size_t>(kBeyond - k)][c] / (kBeyond - kBeside + 1);
                right[c] += across[static_cast<std::size_t>(kBeyond + k)][c] / (kBeyond - kBeside + 1);
            }
        const float sides = size_of(less(left, right));
        for (int k = -kMiddle; k <= kMiddle; ++k) {
            const Colour one = less(across[static_cast<std::size_t>(kBeyond + k)], left),
                         other = less(across[static_cast<std::size_t>(kBeyond + k)], right);
            const float least = std::min(size_of(one), size_of(other));
            if (least > kDiffers && least > kMoreThanSides * sides && dot(one, other) > kSameWay * size_of(one) * size_of(other))
                return true;
        }
        return false;
    }

    const std::vector<std::vector<float>>& lab_;
    int width_, height_;
};

// The stronger of the pixels beside a step, as along arcs.
float strength_at(const EdgeMap& map, const Point& p) {
    float strength = 0;
    for (const double dx : {-0.25, 0.25})
        for (const double dy : {-0.25, 0.25}) {
            const int x = std::clamp(static_cast<int>(p.x + dx), 0, map.width - 1),
                      y = std::clamp(static_cast<int>(p.y + dy), 0, map.height - 1);
            strength = std::max(
                strength,
                map.strength[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x)]);
        }
    return strength;
}

}  // namespace

std::vector<RegionLine> thin_things_of(const RegionTree& tree, const EdgeMap& map, const std::vector<std::vector<float>>& lab,
                                       double shortest) {
    PixelGraph graph;
    for (const Point junction : tree.junctions) graph.junctions.push_back({junction, 0});
    for (const RegionArc& arc : tree.arcs)
        if (arc.strength >= kWeakest) graph.chains.push_back(chain_of(arc, 0));
    const Profiles profiles(lab, tree.width, tree.height);
    std::vector<RegionLine> lines;
    for (const PixelPath& path : join_at_junctions(graph)) {
        const std::vector<Point>& points = path.points;
        if (static_cast<double>(points.size()) < shortest) continue;
        const std::vector<bool> thin = profiles.thin_steps(rounded(points, path.closed, kAlong));
        std::vector<std::size_t> before{0};  // how many of the steps before each are thin
        for (const bool t : thin) before.push_back(before.back() + (t ? 1 : 0));
        const auto reach = static_cast<std::size_t>(shortest / 4);
        for (std::size_t i = 0, end; i < points.size(); i = end + 1) {
            double sum = 0;
            for (end = i; end < points.size(); ++end) {
                const std::size_t from = end > reach ? end - reach : 0, to = std::min(end + reach + 1, points.size());
                if (static_cast<double>(before[to] - before[from]) < kMostly * static_cast<double>(to - from)) break;
                sum += static_cast<double>(strength_at(map, points[end]));
            }
            if (static_cast<double>(end - i) < shortest) continue;
            const auto most = static_cast<std::size_t>(shortest);
            const std::size_t before_it = std::min(i, most), after_it = std::min(points.size() - end, most);
            const auto first = points.begin() + static_cast<std::ptrdiff_t>(i - before_it),
                       last = points.begin() + static_cast<std::ptrdiff_t>(end + after_it);
            lines.push_back({{first, last}, static_cast<float>(sum / static_cast<double>(end - i)), {before_it, after_it}});
        }
    }
    return lines;
}

}  // namespace tactics
