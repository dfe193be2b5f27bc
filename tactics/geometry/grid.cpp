// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactics {

namespace {

constexpr double kMostCells = 1000, kMostOuter = 128;  // each way

std::size_t cells_of(double length, double cell) { return length > 0 ? 1 + static_cast<std::size_t>(length / cell) : 0; }

}  // namespace

Grid::Axis Grid::axis_of(double cell, double low, double end, double high, double coarser) {
    Axis axis;
    axis.cell = cell;
    axis.low = low;
    axis.end = end;
    axis.outer = std::max(cell, coarser * std::max(-low, high - end) / kMostOuter);
    axis.before = cells_of(-low, axis.outer);
    axis.within = 1 + static_cast<std::size_t>(end / cell);
    axis.beyond = cells_of(high - end, axis.outer);
    return axis;
}

Grid::Grid(std::vector<Box> boxes, double width, double height) : boxes_(std::move(boxes)) {
    double sides = 0;
    Box all{0, 0, width, height};
    for (const Box& box : boxes_) {
        sides += std::min(box.right - box.left + box.bottom - box.top, 2 * (width + height));
        // Ignores NaN and values outside the usable range.
        constexpr double kFarthest = 1e9;
        all.left = std::min(all.left, std::max(box.left, -kFarthest));
        all.top = std::min(all.top, std::max(box.top, -kFarthest));
        all.right = std::max(all.right, std::min(box.right, kFarthest));
        all.bottom = std::max(all.bottom, std::min(box.bottom, kFarthest));
    }
    const double mean = boxes_.empty() ? 1 : sides / static_cast<double>(2 * boxes_.size());
    double cell = std::max({mean, width / kMostCells, height / kMostCells, 1e-3});
    const std::size_t most = 10 * boxes_.size() + 1000;
    std::vector<Span> spans;
    for (double coarser = 1;; cell *= 2, coarser *= 2) {
        across_ = axis_of(cell, all.left, width, all.right, coarser);
        down_ = axis_of(cell, all.top, height, all.bottom, coarser);
        columns_ = across_.count();
        spans.clear();
        spans.reserve(boxes_.size());
        std::size_t entries = 0;
        for (const Box& box : boxes_) {
            spans.push_back(span_of(box));
            const Span& s = spans.back();
            entries += (std::size_t{s.right} - s.left + 1) * (std::size_t{s.bottom} - s.top + 1);
        }
        constexpr std::size_t kLeast = 3;  // before, within and beyond
        if (entries <= most || (columns_ <= kLeast && down_.count() <= kLeast)) break;
    }
    starts_.assign(columns_ * down_.count() + 1, 0);
    for (const Span& span : spans) each_cell(span, [this](std::size_t at, std::size_t, std::size_t) { ++starts_[at + 1]; });
    for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    entries_.resize(starts_.back());
    begun_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < spans.size(); ++i)
        each_cell(spans[i], [&](std::size_t at, std::size_t row, std::size_t column) {
            const std::uint32_t entry = next[at]++;
            entries_[entry] = static_cast<std::uint32_t>(i);
            begun_[entry] =
                static_cast<std::uint8_t>((column == spans[i].left ? kBegunAcross : 0) | (row == spans[i].top ? kBegunDown : 0));
        });
}

}  // namespace tactics
