// SPDX-License-Identifier: Apache-2.0
#include "filters/cell_places.h"

#include <cmath>

#include "tactics/layout/dot_grid.h"

namespace tactics {

namespace {

constexpr double kCellRounding = 1e-6;  // mm

}  // namespace

CellPlaces::CellPlaces(const Sheet& sheet, const Place& place, Point origin) {
    if (sheet.bed) {
        first_ = {sheet.bed->first.x - origin.x, sheet.bed->first.y - origin.y};
        across_ = sheet.bed->across(sheet.cell);
        down_ = sheet.bed->down(sheet.cell);
    } else if (has_fixed_dots(*sheet.medium)) {
        const DotGrid grid = cell_grid(place.live, sheet.cell);
        first_ = {grid.columns.front() - origin.x, grid.rows.front() - origin.y};
        across_ = sheet.cell.cell_pitch;
        down_ = sheet.cell.line_pitch;
    }
}

Point CellPlaces::nearest(Point at, const LabelBlock& block) const {
    if (anywhere() || block.braille.empty()) return at;
    const Point dot = block.braille[0].first_dot;
    const auto steps = [](double mm, double step) { return std::round(mm / step) * step; };
    return {first_.x + steps(at.x + dot.x - first_.x, across_) - dot.x, first_.y + steps(at.y + dot.y - first_.y, down_) - dot.y};
}

Point CellPlaces::next(Point at, const LabelBlock& block) const {
    Point near = nearest(at, block);
    if (near.x < at.x - kCellRounding) near.x += across_;
    if (near.y < at.y - kCellRounding) near.y += down_;
    return near;
}

Point CellPlaces::next_cell(Point at) const {
    if (anywhere()) return at;
    const auto next = [](double mm, double step) { return std::ceil(mm / step - kCellRounding) * step; };
    return {first_.x + next(at.x - first_.x, across_), first_.y + next(at.y - first_.y, down_)};
}

}  // namespace tactics
