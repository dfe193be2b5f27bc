// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "print/height_files.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::size_t kMostTriangles = 10'000'000;  // 500 MB; slicers give up far below
constexpr std::size_t kHeaderBytes = 84, kTriangleBytes = 50;

using StlCorner = std::array<float, 3>;

void put(char* to, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) to[i] = static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
}

// The surface has a corner at each sample and, so that the solid is as large as the map, at its edges, where the heights of the
// outermost samples go on. A corner whose neighbours all have its height is left out. Whether it is depends on nothing else, so
// that the strips above and below a row use the same corners of it, and no edge has a third triangle or none.
class Solid {
public:
    Solid(const HeightSheet& sheet, double base, std::string_view place) : sheet_(sheet), base_(base), place_(place) {
        // A text STL begins with "solid"; this must not.
        file_ = "TACTICS height map, mm, base " + to_text(base);
        file_.resize(kHeaderBytes, '\0');
    }

    std::string finish(const HeightRows& rows) {
        const int last = sheet_.rows + 1;  // rows of corners: 0 and last are at the edges
        std::vector<float> above, row = next(rows, 0), below = row;
        for (int j = 0; j <= last; ++j) {
            std::vector<StlCorner> line;
            for (int i = 0; i <= sheet_.columns + 1; ++i)
                if (is_kept(above, row, below, static_cast<std::size_t>(i)))
                    line.push_back({x_of(i), y_of(j), row[static_cast<std::size_t>(i)]});
            if (j == 0) top_ = line;
            if (j > 0) add_strip(line_, line);
            left_.push_back(line.front());
            right_.push_back(line.back());
            line_ = std::move(line);
            above = std::move(row);
            row = std::move(below);
            below = j + 2 < last ? next(rows, j + 1) : j + 2 == last ? row : std::vector<float>();
        }
        add_sides();
        put(file_.data() + kHeaderBytes - 4, static_cast<std::uint32_t>((file_.size() - kHeaderBytes) / kTriangleBytes));
        return std::move(file_);
    }

private:
    float x_of(int i) const {
        return static_cast<float>(i == 0 ? 0 : i > sheet_.columns ? sheet_.columns * sheet_.pitch : (i - 0.5) * sheet_.pitch);
    }
    // Rows come from the top, and y goes up.
    float y_of(int j) const {
        return static_cast<float>(j == 0            ? sheet_.rows * sheet_.pitch
                                  : j > sheet_.rows ? 0
                                                    : (sheet_.rows - j + 0.5) * sheet_.pitch);
    }

    std::vector<float> next(const HeightRows& rows, int y) const {
        std::vector<float> row(static_cast<std::size_t>(sheet_.columns) + 2);
        rows(y, std::span<float>(row).subspan(1, row.size() - 2));
        for (float& height : row)
            height = static_cast<float>(base_ + (height > sheet_.low ? std::min<double>(height, sheet_.high) - sheet_.low : 0));
        row.front() = row[1];
        row.back() = row[row.size() - 2];
        return row;
    }

    static bool is_kept(const std::vector<float>& above, const std::vector<float>& row, const std::vector<float>& below,
                        std::size_t i) {
        if (i == 0 || i + 1 == row.size()) return true;
        const auto differs = [&](const std::vector<float>& other) {
            return !other.empty() && (other[i - 1] != row[i] || other[i] != row[i] || other[i + 1] != row[i]);
        };
        return differs(row) || differs(above) || differs(below);
    }

    void add(const StlCorner& a, const StlCorner& b, const StlCorner& c) {
        if (file_.size() >= kHeaderBytes + kTriangleBytes * kMostTriangles)
            throw Error(Fault::usage, place_,
                        phrase("this solid would have over {0} million triangles; take a larger pitch",
                               to_text(static_cast<double>(kMostTriangles) / 1e6)));
        const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2], vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
        const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx,
                     size = std::sqrt(nx * nx + ny * ny + nz * nz);
        const std::array<StlCorner, 4> all{
            StlCorner{static_cast<float>(nx / size), static_cast<float>(ny / size), static_cast<float>(nz / size)}, a, b, c};
        std::array<char, kTriangleBytes> bytes{};
        for (std::size_t i = 0; i < 12; ++i) put(bytes.data() + 4 * i, std::bit_cast<std::uint32_t>(all[i / 3][i % 3]));
        file_.append(bytes.data(), bytes.size());
    }

    // Between two rows, from left to right, always to the nearer next corner.
    void add_strip(const std::vector<StlCorner>& upper, const std::vector<StlCorner>& lower) {
        std::size_t a = 0, b = 0;
        while (a + 1 < upper.size() || b + 1 < lower.size()) {
            const bool down = a + 1 == upper.size() || (b + 1 < lower.size() && lower[b + 1][0] <= upper[a + 1][0]);
            if (down) {
                add(upper[a], lower[b], lower[b + 1]);
                ++b;
            } else {
                add(upper[a], lower[b], upper[a + 1]);
                ++a;
            }
        }
    }

    // Upright sides, and the bottom as a fan around its middle.
    void add_sides() {
        std::vector<StlCorner> around(line_.begin(),
                                      line_.end());  // anticlockwise as seen from above, from the left lower corner
        around.insert(around.end(), right_.rbegin() + 1, right_.rend());
        around.insert(around.end(), top_.rbegin() + 1, top_.rend());
        around.insert(around.end(), left_.begin() + 1, left_.end() - 1);
        const StlCorner middle{static_cast<float>(sheet_.columns * sheet_.pitch / 2),
                               static_cast<float>(sheet_.rows * sheet_.pitch / 2), 0};
        for (std::size_t i = 0; i < around.size(); ++i) {
            const StlCorner &p = around[i], &q = around[(i + 1) % around.size()];
            const StlCorner under_p{p[0], p[1], 0}, under_q{q[0], q[1], 0};
            add(under_p, under_q, q);
            add(under_p, q, p);
            add(middle, under_q, under_p);
        }
    }

    const HeightSheet& sheet_;
    double base_;
    std::string_view place_;
    std::string file_;
    std::vector<StlCorner> line_, top_, left_, right_;
};

}  // namespace

std::string height_stl(const HeightSheet& sheet, const HeightRows& rows, double base, std::string_view place) {
    return Solid(sheet, base, place).finish(rows);
}

}  // namespace tactics
