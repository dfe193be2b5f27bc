// SPDX-License-Identifier: Apache-2.0
#include "tactics/relief/depth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/error.h"
#include "tactics/readers/stl.h"

namespace tactics {

namespace {

constexpr double kMostVisits = 20e9;  // samples and rows under all triangles: a minute or two

// As many whole squares as the length needs; a last one would not be worth a rounding error.
double squares(double length, double pitch) { return std::max(1.0, std::ceil(length / pitch - 1e-6)); }

// In units of the map: a sample's centre is at a whole number.
using Corner = std::array<double, 3>;

class Depth {
public:
    Depth(HeightMap& map, const std::string& name) : map_(map), name_(name) {}

    void add(std::array<Corner, 3> corners) {
        const auto [least, most] = std::minmax({corners[0][1], corners[1][1], corners[2][1]});
        const int first = static_cast<int>(std::max(0.0, std::ceil(least))),
                  end = static_cast<int>(std::min<double>(map_.rows, std::floor(most) + 1));
        const double area = (corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) -
                            (corners[2][0] - corners[0][0]) * (corners[1][1] - corners[0][1]);
        count(1);
        if (area == 0) return;  // upright: only its upper edge could be seen, and that belongs to others, too
        for (int y = first; y < end; ++y) row(corners, y);
    }

private:
    // Two triangles that share an edge must find the same place on it, or a sample between them would be missed. So an edge is
    // always taken from its end that comes first.
    static Corner on_edge(const Corner& a, const Corner& b, double y) {
        const Corner &from = std::min(a, b), &to = std::max(a, b);
        const double part = (y - from[1]) / (to[1] - from[1]);
        return {from[0] + part * (to[0] - from[0]), y, from[2] + part * (to[2] - from[2])};
    }

    void row(const std::array<Corner, 3>& corners, int y) {
        std::array<Corner, 6> met{};
        std::size_t count_met = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner &a = corners[i], &b = corners[(i + 1) % 3];
            if (a[1] == y) met[count_met++] = a;
            if ((a[1] < y && b[1] > y) || (a[1] > y && b[1] < y)) met[count_met++] = on_edge(a, b, y);
        }
        if (count_met == 0) return;
        const auto [left, right] = std::minmax_element(met.begin(), met.begin() + static_cast<std::ptrdiff_t>(count_met));
        const double from = std::max(0.0, std::ceil((*left)[0])), to = std::min(map_.columns - 1.0, std::floor((*right)[0]));
        const double wide = (*right)[0] - (*left)[0], rise = (*right)[2] - (*left)[2];
        count(std::max(1.0, to - from + 1));
        for (int x = static_cast<int>(from); x <= static_cast<int>(to); ++x) {
            const double z = wide > 0 ? (*left)[2] + rise * ((x - (*left)[0]) / wide) : std::max((*left)[2], (*right)[2]);
            float& height = map_.at(x, y);
            height = std::max(height, static_cast<float>(z));
        }
    }

    void count(double visits) {
        visits_ += visits;
        if (visits_ > kMostVisits)
            throw Error(Fault::failed, name_,
                        phrase("has so many triangles over each other that this would take minutes; take a larger pitch or a "
                               "simpler model"));
    }

    HeightMap& map_;
    const std::string& name_;
    double visits_ = 0;
};

}  // namespace

ModelBox box_of(const Triangles& triangles) {
    ModelBox box;
    std::fill(box.low, box.low + 3, INFINITY);
    std::fill(box.high, box.high + 3, -INFINITY);
    triangles([&](const Triangle& triangle) {
        for (const auto& corner : triangle.corners)
            for (std::size_t k = 0; k < 3; ++k) {
                box.low[k] = std::min(box.low[k], corner[k]);
                box.high[k] = std::max(box.high[k], corner[k]);
            }
    });
    return box;
}

double depth_columns(const ModelBox& box, double scale, double pitch) { return squares(box.size(0) * scale, pitch); }
double depth_rows(const ModelBox& box, double scale, double pitch) { return squares(box.size(1) * scale, pitch); }

HeightMap depth_of(const Triangles& triangles, const ModelBox& box, double scale, double pitch, const std::string& name) {
    HeightMap map;
    map.columns = static_cast<int>(depth_columns(box, scale, pitch));
    map.rows = static_cast<int>(depth_rows(box, scale, pitch));
    map.pitch = pitch;
    map.heights.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows), 0.0f);
    const double left = (map.width() - box.size(0) * scale) / 2, top = (map.height() - box.size(1) * scale) / 2;
    Depth depth(map, name);
    triangles([&](const Triangle& triangle) {
        std::array<Corner, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& [x, y, z] = triangle.corners[i];
            corners[i] = {(left + (x - box.low[0]) * scale) / pitch - 0.5, (top + (box.high[1] - y) * scale) / pitch - 0.5,
                          (z - box.low[2]) * scale};
        }
        depth.add(corners);
    });
    return map;
}

}  // namespace tactics
