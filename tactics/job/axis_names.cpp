// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/axis_names.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace tactics {

namespace {

bool is_alone_at_side(const PrintPlace& name, const std::vector<PrintPlace>& places, double width) {
    constexpr double kSide = 0.15, kNear = 0.15;  // of the width; settings
    if (name.at.x > kSide * width && name.at.x < (1 - kSide) * width) return false;
    return std::none_of(places.begin(), places.end(), [&](const PrintPlace& other) {
        return &other != &name && other.upwards && !other.number && std::abs(other.at.x - name.at.x) < kNear * width;
    });
}

}  // namespace

void place_axis_names(std::vector<PrintPlace>& places, double width) {
    for (PrintPlace& name : places) {
        if (!name.upwards || name.number) continue;  // R sets numbers upwards, too
        std::optional<Point> top;
        std::size_t above = 0, below = 0;
        for (const PrintPlace& other : places) {
            if ((other.upwards && !other.number) || std::abs(other.at.x - name.at.x) > width / 4) continue;
            ++(other.at.y < name.at.y ? above : below);
            if (!top || other.at.y < top->y) top = other.at;
        }
        // An axis has numbers on both sides of the middle, where its name is. One without any has its name alone at the side.
        if (above == 0 && below == 0) name.loose = is_alone_at_side(name, places, width);
        if (above == 0 || below == 0) continue;
        name.at = {(name.at.x + top->x) / 2, top->y - 2 * name.height};
        name.loose = true;
    }
    std::vector<double> rows;  // of numbers, which stay where they are
    for (const PrintPlace& other : places)
        if (other.number) rows.push_back(other.at.y);
    std::sort(rows.begin(), rows.end());
    for (PrintPlace& name : places) {
        if (name.upwards || name.number) continue;
        // Letters: print stands 1.5 to 3 of them below the numbers. Braille, at the usual sizes of a page, needs twice that.
        constexpr double kNear = 3, kLower = 3.5;
        const auto highest = std::upper_bound(rows.begin(), rows.end(), name.at.y - kNear * name.height);
        const auto numbers = std::lower_bound(highest, rows.end(), name.at.y - name.height) - highest;
        constexpr int kRow = 3;
        if (numbers < kRow) continue;
        name.at.y += kLower * name.height;
        name.loose = true;
    }
}

}  // namespace tactics
