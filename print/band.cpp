// SPDX-License-Identifier: Apache-2.0
#include "print/band.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tactics {

void add_edge(std::vector<Edge>& edges, const Point& from, const Point& to) {
    if (from.y == to.y) return;
    const bool down = from.y < to.y;
    const Point& a = down ? from : to;
    const Point& b = down ? to : from;
    edges.push_back({a.y, b.y, a.x, (b.x - a.x) / (b.y - a.y), down ? 1 : -1});
}

void sort_edges(std::vector<Edge>& edges) {
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.top < b.top; });
}

Band::Band(const Page& page, int width, int height)
    : page_width_(page.width),
      width_(width),
      columns_per_mm_(width / page.width),
      mm_per_row_(page.height / height),
      row_bytes_((static_cast<std::size_t>(width) + 7) / 8) {}

void Band::begin(int first, int rows) {
    first_ = first;
    end_ = first + rows;
    bits_.assign(row_bytes_ * static_cast<std::size_t>(rows), 0);
}

int Band::row_from(double y) const {
    return static_cast<int>(std::clamp(std::ceil(y / mm_per_row_ - 0.5), static_cast<double>(first_), static_cast<double>(end_)));
}

// All pixels with their centres in [left, right).
void Band::span(int y, double left, double right) {
    const double from_column = std::max(std::ceil(left * columns_per_mm_ - 0.5), 0.0);
    const double end_column = std::min(std::ceil(right * columns_per_mm_ - 0.5), static_cast<double>(width_));
    if (!(from_column < end_column)) return;
    const auto from = static_cast<std::size_t>(from_column);
    const auto last = static_cast<std::size_t>(end_column) - 1;
    std::uint8_t* bytes = row(y);
    const auto head = static_cast<std::uint8_t>(0xFFu >> (from % 8));
    const auto tail = static_cast<std::uint8_t>(0xFFu << (7 - last % 8));
    if (from / 8 == last / 8) {
        bytes[from / 8] = static_cast<std::uint8_t>(bytes[from / 8] | (head & tail));
        return;
    }
    bytes[from / 8] |= head;
    std::memset(bytes + from / 8 + 1, 0xFF, last / 8 - from / 8 - 1);
    bytes[last / 8] |= tail;
}

// The points within `radius` of a segment form a convex shape, so every row meets it in one span: from the leftmost to the
// rightmost of its intersections with the two end discs and the two long sides.
void Band::segment(const Point& from, const Point& to, double radius) {
    const int begin_row = row_from(std::min(from.y, to.y) - radius);
    const int end_row = row_from(std::max(from.y, to.y) + radius);
    if (begin_row >= end_row) return;
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double length = std::hypot(dx, dy);
    const double across_x = length > 0 ? -dy / length * radius : 0;  // from the middle line to one side
    const double across_y = length > 0 ? dx / length * radius : 0;
    for (int row = begin_row; row < end_row; ++row) {
        const double y = y_of(row);
        double left = page_width_ * 2, right = -left;
        const auto meet = [&](double x) {
            left = std::min(left, x);
            right = std::max(right, x);
        };
        const auto disc = [&](const Point& centre) {
            const double rest = radius * radius - (y - centre.y) * (y - centre.y);
            if (rest < 0) return;
            const double half = std::sqrt(rest);
            meet(centre.x - half);
            meet(centre.x + half);
        };
        disc(from);
        disc(to);
        if (dy != 0) {
            const double one = (y - from.y - across_y) / dy, other = (y - from.y + across_y) / dy;
            if (one >= 0 && one <= 1) meet(from.x + across_x + one * dx);
            if (other >= 0 && other <= 1) meet(from.x - across_x + other * dx);
        }
        span(row, left, right);
    }
}

void Band::stroke(const PageStroke& stroke) {
    const auto& points = stroke.points;
    if (points.empty()) return;
    const double radius = stroke.width / 2;
    if (points.size() == 1) segment(points[0], points[0], radius);
    for (std::size_t i = 1; i < points.size(); ++i) segment(points[i - 1], points[i], radius);
    if (stroke.closed) segment(points.back(), points.front(), radius);
}

void Band::fill(const std::vector<Edge>& edges, FillRule rule) {
    active_.clear();
    std::size_t next = 0;
    for (int row = edges.empty() ? end_ : row_from(edges.front().top); row < end_; ++row) {
        const double y = y_of(row);
        for (; next < edges.size() && edges[next].top <= y; ++next)
            if (edges[next].bottom > y) active_.push_back(next);
        std::erase_if(active_, [&](std::size_t i) { return edges[i].bottom <= y; });
        if (active_.empty() && next == edges.size()) return;
        crossings_.clear();
        for (const std::size_t i : active_)
            crossings_.emplace_back(edges[i].x + (y - edges[i].top) * edges[i].slope, edges[i].turn);
        std::sort(crossings_.begin(), crossings_.end());
        int winding = 0;
        for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
            winding += crossings_[i].second;
            if (rule == FillRule::non_zero ? winding != 0 : i % 2 == 0) span(row, crossings_[i].first, crossings_[i + 1].first);
        }
    }
}

}  // namespace tactics
