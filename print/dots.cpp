// SPDX-License-Identifier: Apache-2.0
#include "print/dots.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "print/dot_chain.h"

namespace tactics {

namespace {

void raise_line(std::span<const Point> points, bool closed, const DotGrid& grid, Dots& dots) {
    for (const GridDot dot : dot_chain(points, closed, grid))
        if (dot.column >= 0 && dot.column < dots.columns && dot.row >= 0 && dot.row < dots.rows) dots.at(dot.column, dot.row) = 1;
}

// Each side of a ring turns inside to outside for all dots to its right in the rows that it crosses: one mark a row,
// and a walk along the rows at the end. A row counts as crossed from its lower end up to, not with, its upper end.
void raise_area(const Area& area, const DotGrid& grid, Dots& dots) {
    Dots turns{dots.columns, dots.rows, std::vector<std::uint8_t>(dots.raised.size())};
    for (const auto& ring : area.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if (a.y > b.y) std::swap(a, b);
            const auto first = std::lower_bound(grid.rows.begin(), grid.rows.end(), a.y);
            const auto end = std::lower_bound(first, grid.rows.end(), b.y);
            for (auto row = first; row != end; ++row) {
                const double x = a.x + (b.x - a.x) * ((*row - a.y) / (b.y - a.y));
                const auto column = std::lower_bound(grid.columns.begin(), grid.columns.end(), x);
                if (column != grid.columns.end())
                    turns.at(static_cast<int>(column - grid.columns.begin()), static_cast<int>(row - grid.rows.begin())) ^= 1;
            }
        }
    }
    bool any = false;
    for (int row = 0; row < dots.rows; ++row) {
        std::uint8_t inside = 0;
        for (int column = 0; column < dots.columns; ++column) {
            inside ^= turns.at(column, row);
            if (inside == 0) continue;
            dots.at(column, row) = 1;
            any = true;
        }
    }
    if (any) return;
    for (const auto& ring : area.rings) raise_line(ring, true, grid, dots);
}

// The middles between dots, and as far beyond the first and the last.
std::vector<double> borders(const std::vector<double>& centres) {
    std::vector<double> found;
    found.push_back(centres[0] - (centres[1] - centres[0]) / 2);
    for (std::size_t i = 1; i < centres.size(); ++i) found.push_back((centres[i - 1] + centres[i]) / 2);
    found.push_back(centres.back() + (centres.back() - centres[centres.size() - 2]) / 2);
    return found;
}

// Black pixels of a row from `left` up to, not with, `right`.
int black_in(const std::uint8_t* row, int left, int right) {
    int count = 0;
    for (int x = left; x < right;) {
        const unsigned byte = row[x / 8];
        if (x % 8 == 0 && right - x >= 8) {
            count += std::popcount(byte);
            x += 8;
        } else {
            count += static_cast<int>(byte >> (7 - x % 8) & 1u);
            ++x;
        }
    }
    return count;
}

// Which share of the paper around each dot is black.
std::vector<float> blackness(const Bitmap& picture, const DotGrid& grid) {
    const std::vector<double> across = borders(grid.columns), down = borders(grid.rows);
    const double pixel_width = picture.place.width / picture.width, pixel_height = picture.place.height / picture.height;
    const auto pixel = [](double at, double origin, double size, int limit) {
        return static_cast<int>(std::clamp(std::ceil((at - origin) / size - 0.5), 0.0, static_cast<double>(limit)));
    };
    std::vector<int> columns;
    for (const double x : across) columns.push_back(pixel(x, picture.place.left, pixel_width, picture.width));
    std::vector<float> shares;
    for (std::size_t r = 0; r + 1 < down.size(); ++r) {
        const int top = pixel(down[r], picture.place.top, pixel_height, picture.height);
        const int bottom = pixel(down[r + 1], picture.place.top, pixel_height, picture.height);
        for (std::size_t c = 0; c + 1 < across.size(); ++c) {
            long long black = 0;
            for (int y = top; y < bottom; ++y)
                black +=
                    black_in(picture.bits.data() + picture.row_bytes() * static_cast<std::size_t>(y), columns[c], columns[c + 1]);
            const double pixels = (across[c + 1] - across[c]) * (down[r + 1] - down[r]) / (pixel_width * pixel_height);
            shares.push_back(static_cast<float>(static_cast<double>(black) / pixels));
        }
    }
    return shares;
}

void raise_picture(const Bitmap& picture, const DotGrid& grid, Dots& dots) {
    if (picture.width <= 0 || picture.height <= 0 || !(picture.place.width > 0) || !(picture.place.height > 0)) return;
    const std::vector<float> shares = blackness(picture, grid);
    const auto share = [&](int column, int row) {
        if (column < 0 || column >= dots.columns || row < 0 || row >= dots.rows) return 0.0f;
        return shares[static_cast<std::size_t>(row) * static_cast<std::size_t>(dots.columns) + static_cast<std::size_t>(column)];
    };
    // A line of 1 mm, narrower than the paper around a dot (2.5 to 3.75 mm), fills a quarter of it, or an eighth of two
    // when it runs between them: it is found as the row or column of dots that is blacker than those on both sides.
    constexpr float kLeastLine = 0.12f;
    for (int row = 0; row < dots.rows; ++row) {
        for (int column = 0; column < dots.columns; ++column) {
            const float own = share(column, row);
            const bool ridge = own >= kLeastLine && ((own > share(column - 1, row) && own >= share(column + 1, row)) ||
                                                     (own > share(column, row - 1) && own >= share(column, row + 1)));
            if (own >= 0.5f || ridge) dots.at(column, row) = 1;
        }
    }
}

}  // namespace

Dots raise_dots(const Page& page, const DotGrid& grid) {
    Dots dots{static_cast<int>(grid.columns.size()), static_cast<int>(grid.rows.size()), {}};
    dots.raised.resize(grid.columns.size() * grid.rows.size());
    if (page.picture) raise_picture(*page.picture, grid, dots);
    for (const Area& area : page.areas) raise_area(area, grid, dots);
    for (const PageStroke& stroke : page.strokes) raise_line(stroke.points, stroke.closed, grid, dots);
    return dots;
}

namespace {

// As raise_dots, with the page's braille, on a raster of which its cells are multiples. Each braille line begins at the nearest
// dot.
Dots raise_page(const Page& page, const DotGrid& raster) {
    Dots dots = raise_dots(page, raster);
    const double pitch = raster.columns[1] - raster.columns[0];
    const auto nearest = [pitch](double at, double first) { return std::round((at - first) / pitch); };
    for (BrailleLine line : page.braille) {
        line.first_dot = {raster.columns[0] + nearest(line.first_dot.x, raster.columns[0]) * pitch,
                          raster.rows[0] + nearest(line.first_dot.y, raster.rows[0]) * pitch};
        for (const Point dot : dots_of(line, page.cell)) {
            const double column = nearest(dot.x, raster.columns[0]), row = nearest(dot.y, raster.rows[0]);
            if (column >= 0 && column < dots.columns && row >= 0 && row < dots.rows)
                dots.at(static_cast<int>(column), static_cast<int>(row)) = 1;
        }
    }
    return dots;
}

}  // namespace

Dots raise_on_bed(const Page& page) {
    if (!page.bed || !(page.bed->raster > 0)) throw std::logic_error("a page for another machine");
    const DotGrid raster = dot_grid(page);
    const Dots drawn = raise_page(page, raster);
    const int left = static_cast<int>(std::lround((raster.columns[0] - page.bed->first.x) / page.bed->raster));
    const int above = static_cast<int>(std::lround((raster.rows[0] - page.bed->first.y) / page.bed->raster));
    Dots dots{std::max(0, left + drawn.columns), std::max(0, above + drawn.rows), {}};
    dots.raised.resize(static_cast<std::size_t>(dots.columns) * static_cast<std::size_t>(dots.rows));
    for (int row = std::max(0, -above); row < drawn.rows; ++row)
        for (int column = std::max(0, -left); column < drawn.columns; ++column)
            dots.at(left + column, above + row) = drawn.at(column, row);
    return dots;
}

Dots kinds_on_bed(const Page& page) {
    constexpr auto kLowest = static_cast<std::uint8_t>(kLineKinds);
    Dots kinds = raise_on_bed(page);
    for (std::uint8_t& dot : kinds.raised) dot = dot != 0 ? kLowest : 0;
    // With the lines of lower kinds first, so that a higher one takes the dots that it shares with them.
    Page higher = page;
    for (std::uint8_t kind = kLowest - 1; kind > 0; --kind) {
        std::erase_if(higher.strokes,
                      [kind](const PageStroke& stroke) { return static_cast<std::uint8_t>(kind_of(stroke)) >= kind; });
        const Dots dots = raise_on_bed(higher);
        for (std::size_t i = 0; i < dots.raised.size(); ++i)
            if (dots.raised[i] != 0 && kinds.raised[i] != 0) kinds.raised[i] = kind;
    }
    return kinds;
}

}  // namespace tactics
