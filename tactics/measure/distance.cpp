// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/distance.h"

#include <algorithm>

namespace tactics {

namespace {

// One row: the lower envelope of a parabola over each column, whose foot is the square of the way up or down to the set.
class Row {
public:
    explicit Row(int width) : width_(width), columns_(static_cast<std::size_t>(width)), from_(static_cast<std::size_t>(width)) {}

    // `far` has the ways up or down, -1 where the column has none.
    void solve(const std::int64_t* far, std::int64_t* squares) {
        const auto value = [&](std::int64_t x, int column) { return (x - column) * (x - column) + far[column] * far[column]; };
        std::size_t kept = 0;
        for (int column = 0; column < width_; ++column) {
            if (far[column] < 0) continue;
            while (kept > 0 && value(from_[kept - 1], columns_[kept - 1]) > value(from_[kept - 1], column)) --kept;
            std::int64_t begin = 0;
            if (kept > 0) {
                begin = beyond(columns_[kept - 1], column, far);
                if (begin >= width_) continue;
            }
            columns_[kept] = column;
            from_[kept++] = begin;
        }
        std::size_t parabola = kept;
        for (int x = width_ - 1; x >= 0; --x) {
            while (parabola > 1 && from_[parabola - 1] > x) --parabola;
            squares[x] = parabola == 0 ? kNoDistance : value(x, columns_[parabola - 1]);
        }
    }

private:
    // The first x at which the later column is nearer; it is not nearer at 0.
    static std::int64_t beyond(std::int64_t a, std::int64_t b, const std::int64_t* far) {
        const std::int64_t sum = b * b - a * a + far[b] * far[b] - far[a] * far[a], twice = 2 * (b - a);
        return sum / twice + 1;
    }

    int width_;
    std::vector<int> columns_;
    std::vector<std::int64_t> from_;
};

}  // namespace

std::vector<std::int64_t> squared_distances(const PixelSet& set) {
    const auto width = static_cast<std::size_t>(set.width), height = static_cast<std::size_t>(set.height);
    std::vector<std::int64_t> far(width * height, -1), squares(width * height, kNoDistance);
    for (const std::uint32_t pixel : set.pixels) far[pixel] = 0;
    for (std::size_t i = width; i < far.size(); ++i)
        if (far[i] != 0 && far[i - width] >= 0) far[i] = far[i - width] + 1;
    for (std::size_t i = far.size(); i-- > 0;)
        if (i + width < far.size() && far[i + width] >= 0 && (far[i] < 0 || far[i] > far[i + width] + 1))
            far[i] = far[i + width] + 1;
    Row row(set.width);
    for (std::size_t y = 0; y < height; ++y) row.solve(far.data() + y * width, squares.data() + y * width);
    return squares;
}

}  // namespace tactics
