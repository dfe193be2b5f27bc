// SPDX-License-Identifier: Apache-2.0
// Some rows of a black-and-white page, with drawing functions. Coordinates are in mm on the page.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// A side of an outline, running down the page.
struct Edge {
    double top = 0;     ///< y where it begins
    double bottom = 0;  ///< y where it ends
    double x = 0;       ///< at the top
    double slope = 0;   ///< change of x with y
    int turn = 0;       ///< +1 or -1: direction of the outline
};
void add_edge(std::vector<Edge>& edges, const Point& from, const Point& to);  ///< skips horizontal edges
void sort_edges(std::vector<Edge>& edges);                                    ///< by top, as Band::fill expects

enum class FillRule { even_odd, non_zero };

class Band {
public:
    /// For a page of `width` x `height` pixels.
    Band(const Page& page, int width, int height);

    void begin(int first, int rows);  ///< clears it and moves it
    int first() const { return first_; }
    int end() const { return end_; }
    std::size_t row_bytes() const { return row_bytes_; }
    std::uint8_t* row(int y) { return bits_.data() + row_bytes_ * static_cast<std::size_t>(y - first_); }

    void segment(const Point& from, const Point& to, double radius);  ///< with round ends; a dot if both points are equal
    void stroke(const PageStroke& stroke);
    void fill(const std::vector<Edge>& edges, FillRule rule);

private:
    void span(int y, double left, double right);
    double y_of(int row) const { return (row + 0.5) * mm_per_row_; }
    int row_from(double y) const;  ///< the first row of the band with its centre at or below y

    double page_width_;
    int width_;
    double columns_per_mm_;
    double mm_per_row_;
    std::size_t row_bytes_;
    int first_ = 0;
    int end_ = 0;
    std::vector<std::uint8_t> bits_;
    std::vector<std::pair<double, int>> crossings_;
    std::vector<std::size_t> active_;
};

}  // namespace tactics
