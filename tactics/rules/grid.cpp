#include "tactics/rules/grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactics {

namespace {

constexpr double kMostCells = 1000;  // each way

// Which of `count` cells: what lies outside belongs to the first or the last. NaN to the first.
std::size_t cell_at(double place, double cell, std::size_t count) {
    const double number = place / cell;
    if (!(number > 0)) return 0;
    return number >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(number);
}

}  // namespace

Grid::Grid(std::vector<Box> boxes, double width, double height) : boxes_(std::move(boxes)) {
    double sides = 0;
    for (const Box& box : boxes_) sides += std::min(box.right - box.left + box.bottom - box.top, 2 * (width + height));
    const double mean = boxes_.empty() ? 1 : sides / static_cast<double>(2 * boxes_.size());
    double cell = std::max({mean, width / kMostCells, height / kMostCells, 1e-3});
    const std::size_t most = 10 * boxes_.size() + 1000;
    for (;; cell *= 2) {
        cell_ = cell;
        columns_ = 1 + static_cast<std::size_t>(width / cell);
        rows_ = 1 + static_cast<std::size_t>(height / cell);
        spans_.clear();
        std::size_t entries = 0;
        for (const Box& box : boxes_) {
            spans_.push_back(span_of(box));
            const Span& s = spans_.back();
            entries += (s.right - s.left + 1) * (s.bottom - s.top + 1);
        }
        if (entries <= most || (columns_ == 1 && rows_ == 1)) break;
    }
    starts_.assign(columns_ * rows_ + 1, 0);
    const auto each_cell = [this](std::size_t i, const auto& visit) {
        for (std::size_t row = spans_[i].top; row <= spans_[i].bottom; ++row)
            for (std::size_t column = spans_[i].left; column <= spans_[i].right; ++column) visit(row * columns_ + column);
    };
    for (std::size_t i = 0; i < boxes_.size(); ++i) each_cell(i, [this](std::size_t c) { ++starts_[c + 1]; });
    for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    entries_.resize(starts_.back());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        each_cell(i, [&](std::size_t c) { entries_[next[c]++] = static_cast<std::uint32_t>(i); });
}

std::size_t Grid::column_of(double x) const { return cell_at(x, cell_, columns_); }
std::size_t Grid::row_of(double y) const { return cell_at(y, cell_, rows_); }

Grid::Span Grid::span_of(const Box& box) const {
    return {column_of(box.left), row_of(box.top), column_of(box.right), row_of(box.bottom)};
}

}  // namespace tactics
