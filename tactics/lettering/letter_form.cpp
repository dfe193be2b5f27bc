// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/letter_form.h"

#include <algorithm>
#include <cmath>
#include <compare>

namespace tactics {

namespace {

constexpr double kSquares = 96;  // of an em; print in figures has 10 to 50 pixels for one
constexpr double kMostEm = 4;    // of a letter; more is no letter

struct Crossing {
    double x;
    int way;  // whether the ring runs upwards there
    auto operator<=>(const Crossing&) const = default;
};

// Where horizontal lines cross the rings, for each line from the left to the right; `y_of` are their heights, falling.
template <typename HeightOfRow>
std::vector<std::vector<Crossing>> crossings_of(const FontShape& shape, int rows, double top, double height, HeightOfRow y_of) {
    std::vector<std::vector<Crossing>> found(static_cast<std::size_t>(rows));
    const auto row_near = [&](double y) { return static_cast<int>((top - y) / height * rows); };
    for (const auto& ring : shape.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            // One row more at each end, for what is rounded.
            const int first = std::max(0, row_near(std::max(a.y, b.y)) - 1),
                      end = std::min(rows, row_near(std::min(a.y, b.y)) + 2);
            for (int r = first; r < end; ++r) {
                const double y = y_of(r);
                if ((a.y <= y) == (b.y <= y)) continue;
                found[static_cast<std::size_t>(r)].push_back({a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y < b.y ? 1 : -1});
            }
        }
    for (auto& row : found) std::sort(row.begin(), row.end());
    return found;
}

}  // namespace

LetterForm::LetterForm(const FontShape& shape) : advance_(shape.advance) {
    bool any = false;
    for (const auto& ring : shape.rings)
        for (const Point& p : ring) {
            left_ = any ? std::min(left_, p.x) : p.x;
            right_ = any ? std::max(right_, p.x) : p.x;
            bottom_ = any ? std::min(bottom_, p.y) : p.y;
            top_ = any ? std::max(top_, p.y) : p.y;
            any = true;
        }
    if (!any || !(width() > 0) || !(height() > 0) || !(width() < kMostEm) || !(height() < kMostEm)) return;
    columns_ = std::max(1, static_cast<int>(std::ceil(width() * kSquares)));
    rows_ = std::max(1, static_cast<int>(std::ceil(height() * kSquares)));
}

void LetterForm::draw(const FontShape& shape) {
    sums_.assign(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1), 0);
    std::vector<std::uint32_t> row(static_cast<std::size_t>(columns_));
    const auto crossings = crossings_of(shape, rows_, top_, height(), [&](int r) { return top_ - (r + 0.5) / rows_ * height(); });
    for (int r = 0; r < rows_; ++r) {
        std::fill(row.begin(), row.end(), 0u);
        int winding = 0;
        double from = 0;
        for (const auto& [x, way] : crossings[static_cast<std::size_t>(r)]) {
            const double at = (x - left_) / width() * columns_;
            const long begin = std::max(0L, std::lround(from)), end = std::min<long>(columns_, std::lround(at));
            if (winding != 0 && begin < end) std::fill(row.begin() + begin, row.begin() + end, 1u);
            winding += way;
            from = at;
        }
        const std::size_t above = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_ + 1);
        const std::size_t below = above + static_cast<std::size_t>(columns_ + 1);
        std::uint32_t sum = 0;
        for (std::size_t c = 0; c < row.size(); ++c) {
            sum += row[c];
            sums_[below + c + 1] = sums_[above + c + 1] + sum;
        }
    }
}

LetterForm::Place LetterForm::place_of(double part, int squares) {
    const double along = std::clamp(part, 0.0, 1.0) * squares;
    const int square = std::min(static_cast<int>(along), squares - 1);
    return {square, along - square};
}

double LetterForm::ink_before(const Place& across, const Place& down) const {
    const std::uint32_t* above = sums_.data() + static_cast<std::size_t>(down.square) * static_cast<std::size_t>(columns_ + 1) +
                                 static_cast<std::size_t>(across.square);
    const std::uint32_t* below = above + columns_ + 1;
    const double a = across.part, d = down.part;
    const double sum = (1 - d) * ((1 - a) * above[0] + a * above[1]) + d * ((1 - a) * below[0] + a * below[1]);
    return sum / (static_cast<double>(columns_) * rows_);
}

}  // namespace tactics
