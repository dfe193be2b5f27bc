// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/letter_form.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactics {

namespace {

constexpr double kSquares = 96;  // of an em; print in figures has 10 to 50 pixels for one
constexpr double kMostEm = 4;    // of a letter; more is no letter

// Crossings of a horizontal line at that height with the shape: x, and whether the ring runs upwards there.
void find_crossings(const FontShape& shape, double y, std::vector<std::pair<double, int>>& found) {
    found.clear();
    for (const auto& ring : shape.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.y <= y) == (b.y <= y)) continue;
            found.push_back({a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y < b.y ? 1 : -1});
        }
    std::sort(found.begin(), found.end());
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
    std::vector<std::pair<double, int>> crossings;
    for (int r = 0; r < rows_; ++r) {
        std::fill(row.begin(), row.end(), 0u);
        int winding = 0;
        double from = 0;
        find_crossings(shape, top_ - (r + 0.5) / rows_ * height(), crossings);
        for (const auto& [x, way] : crossings) {
            const double at = (x - left_) / width() * columns_;
            if (winding != 0)
                for (int c = std::max(0, static_cast<int>(std::lround(from))); c < std::min<long>(columns_, std::lround(at)); ++c)
                    row[static_cast<std::size_t>(c)] = 1;
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

double LetterForm::ink_before(double x, double y) const {
    const double across = std::clamp(x, 0.0, 1.0) * columns_, down = std::clamp(y, 0.0, 1.0) * rows_;
    const int c = std::min(static_cast<int>(across), columns_ - 1), r = std::min(static_cast<int>(down), rows_ - 1);
    const double a = across - c, d = down - r;
    const double sum =
        (1 - d) * ((1 - a) * sum_at(c, r) + a * sum_at(c + 1, r)) + d * ((1 - a) * sum_at(c, r + 1) + a * sum_at(c + 1, r + 1));
    return sum / (static_cast<double>(columns_) * rows_);
}

}  // namespace tactics
