// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/points_scene.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "tactics/haptics/scenes/plot_part.h"

namespace tactics {

namespace {

constexpr double kMostCellsAcross = 1000;

std::vector<Point3> points_scene_apart(const std::vector<Point3>& points, double merged) {
    std::vector<std::tuple<double, double, double, std::size_t>> cells;
    for (std::size_t i = 0; i < points.size(); ++i)
        cells.emplace_back(std::floor(points[i].x / merged), std::floor(points[i].y / merged), std::floor(points[i].z / merged),
                           i);
    std::sort(cells.begin(), cells.end());
    std::vector<Point3> kept;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto same = [](const auto& a, const auto& b) {
            return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b) && std::get<2>(a) == std::get<2>(b);
        };
        if (i == 0 || !same(cells[i], cells[i - 1])) kept.push_back(points[std::get<3>(cells[i])]);
    }
    return kept;
}

std::unique_ptr<Scene> make_points_scene(const PlotFeel& feel, std::vector<Phrase>& told) {
    std::vector<Point3> points;
    for (const PlotMark& mark : feel.plot.marks) points.push_back(feel.frame.place(mark.x, mark.y, mark.z));
    if (points.empty()) return nullptr;
    auto scene =
        std::make_unique<PointsScene>(points, PointsFeel{3, feel.law.stiffness, feel.law.damping_ns_per_m}, feel.resolution);
    if (scene->size() < points.size())
        told.push_back(phrase("{0} points are felt as {1}: others are within half a millimetre of those",
                              std::to_string(points.size()), std::to_string(scene->size())));
    return scene;
}

}  // namespace

extern const PlotPart points_part;
const PlotPart points_part{"points", "marks that push a finger away", make_points_scene};

PointsScene::PointsScene(const std::vector<Point3>& points, const PointsFeel& feel, double merged) : feel_(feel) {
    const std::vector<Point3> kept = points_scene_apart(points, std::max(merged, feel.radius / 6));
    if (kept.empty()) return;
    Point low{kept[0].x, kept[0].y}, high = low;
    for (const Point3& point : kept) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    cell_ = std::max(feel.radius, std::max(high.x - low.x, high.y - low.y) / kMostCellsAcross);
    corner_ = low;
    columns_ = static_cast<std::size_t>((high.x - low.x) / cell_) + 1;
    rows_ = static_cast<std::size_t>((high.y - low.y) / cell_) + 1;
    const auto cell_of = [&](const Point3& point) {
        const auto column = std::min(static_cast<std::size_t>((point.x - corner_.x) / cell_), columns_ - 1);
        return std::min(static_cast<std::size_t>((point.y - corner_.y) / cell_), rows_ - 1) * columns_ + column;
    };
    starts_.assign(columns_ * rows_ + 1, 0);
    for (const Point3& point : kept) ++starts_[cell_of(point) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    points_.resize(kept.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (const Point3& point : kept) points_[next[cell_of(point)]++] = {point, 1};
    for (Spike& point : points_) {
        int company = 0;
        each_near(point.at, [&](const Spike& other) { company += length_of(point.at - other.at) < feel.radius ? 1 : 0; });
        point.share = 1.0 / std::max(1, company);
    }
}

// Those in the nine cells round it.
template <typename Visit>
void PointsScene::each_near(const Point3& place, Visit visit) const noexcept {
    const double u = (place.x - corner_.x) / cell_, v = (place.y - corner_.y) / cell_;
    if (!(u >= -1 && v >= -1 && u <= static_cast<double>(columns_) + 1 && v <= static_cast<double>(rows_) + 1)) return;
    const auto begin = [](double at) { return static_cast<std::size_t>(std::max(0.0, std::floor(at) - 1)); };
    const auto end = [](double at, std::size_t count) {
        return std::min(static_cast<std::size_t>(std::max(0.0, std::floor(at) + 2)), count);
    };
    for (std::size_t row = begin(v); row < end(v, rows_); ++row)
        for (std::size_t column = begin(u); column < end(u, columns_); ++column)
            for (std::uint32_t i = starts_[row * columns_ + column]; i < starts_[row * columns_ + column + 1]; ++i)
                visit(points_[i]);
}

Felt PointsScene::feel(const Touch& touch, double) noexcept {
    Felt felt;
    each_near(touch.finger, [&](const Spike& point) {
        const Point3 away = touch.finger - point.at;
        const double distance = length_of(away), depth = feel_.radius - distance;
        if (!(depth > 0 && distance > 0)) return;
        const Point3 out = 1 / distance * away;
        const double damped = feel_.damping_ns_per_m / 1000 * std::min(1.0, 2 * depth / feel_.radius) * dot(touch.velocity, out);
        felt.force = felt.force + point.share * std::max(0.0, feel_.stiffness * depth - damped) * out;
    });
    return felt;
}

}  // namespace tactics
