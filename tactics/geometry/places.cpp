// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/places.h"

#include <algorithm>

namespace tactics {

namespace {

constexpr double kMostPlaceCells = 1000;  // each way

std::size_t cells_over(double length, double cell) { return length > 0 ? 1 + static_cast<std::size_t>(length / cell) : 1; }

}  // namespace

Places::Places(const Box& area, double cell)
    : left_(area.left),
      top_(area.top),
      cell_(std::max({cell, (area.right - area.left) / kMostPlaceCells, (area.bottom - area.top) / kMostPlaceCells})),
      columns_(cells_over(area.right - area.left, cell_)),
      rows_(cells_over(area.bottom - area.top, cell_)),
      newest_(columns_ * rows_, kNone) {}

void Places::add(Point point) {
    std::uint32_t& newest = newest_[index_of(point)];
    entries_.push_back({point, newest});
    newest = static_cast<std::uint32_t>(entries_.size() - 1);
}

void Places::shrink(std::size_t size) {
    for (; entries_.size() > size; entries_.pop_back()) newest_[index_of(entries_.back().at)] = entries_.back().next;
}

}  // namespace tactics
