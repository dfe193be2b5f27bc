// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tactics/text/number.h"

namespace tactics {

namespace {

// The samples that are kept of so many.
std::vector<int> kept_of(int count, int every) {
    std::vector<int> kept;
    for (int i = 0; i < count; i += every) kept.push_back(i);
    if (count > 0 && kept.back() != count - 1) kept.push_back(count - 1);
    return kept;
}

// From a grid of places, row by row with y going down; those without a height have no facets.
void add_squares(Mesh& mesh, std::size_t columns, std::size_t rows) {
    if (columns * rows > kMostMeshVertices || 2 * columns * rows > kMostMeshTriangles)
        throw std::logic_error("surface_mesh: more facets than a mesh may have");
    const auto known = [&](std::size_t i) { return std::isfinite(mesh.vertices[i].z); };
    for (std::size_t row = 0; row + 1 < rows; ++row)
        for (std::size_t column = 0; column + 1 < columns; ++column) {
            const std::size_t a = row * columns + column, b = a + 1, c = a + columns, d = c + 1;
            if (!known(a) || !known(b) || !known(c) || !known(d)) continue;
            const auto number = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
            mesh.triangles.push_back({number(a), number(d), number(b)});
            mesh.triangles.push_back({number(a), number(c), number(d)});
        }
    for (Point3& vertex : mesh.vertices)
        if (!std::isfinite(vertex.z)) vertex.z = 0;
}

double height_at(const HeightMap& map, int column, int row) {
    const auto height = static_cast<double>(map.at(column, row));
    return std::isfinite(height) ? height : 0;
}

// The most that the samples of one square of the coarse grid are off its two facets.
double error_in(const HeightMap& map, int left, int right, int top, int bottom) {
    const double a = height_at(map, left, top), b = height_at(map, right, top), c = height_at(map, left, bottom),
                 d = height_at(map, right, bottom);
    double most = 0;
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column) {
            const double u = 1.0 * (column - left) / (right - left), v = 1.0 * (row - top) / (bottom - top);
            const double facet = u >= v ? a + (b - a) * u + (d - b) * v : a + (c - a) * v + (d - c) * u;
            most = std::max(most, std::abs(height_at(map, column, row) - facet));
        }
    return most;
}

double error_of(const HeightMap& map, const std::vector<int>& columns, const std::vector<int>& rows, double enough) {
    double most = 0;
    for (std::size_t j = 0; j + 1 < rows.size(); ++j)
        for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
            most = std::max(most, error_in(map, columns[i], columns[i + 1], rows[j], rows[j + 1]));
            if (most >= enough) return most;
        }
    return most;
}

std::size_t facets_of_grid(std::size_t columns, std::size_t rows) { return 2 * (columns - 1) * (rows - 1); }

}  // namespace

Mesh mesh_of(const HeightMap& map, int every) {
    const std::vector<int> columns = kept_of(map.columns, every), rows = kept_of(map.rows, every);
    Mesh mesh;
    mesh.vertices.reserve(columns.size() * rows.size());
    for (const int row : rows)
        for (const int column : columns)
            mesh.vertices.push_back(
                {(column + 0.5) * map.pitch, map.height() - (row + 0.5) * map.pitch, static_cast<double>(map.at(column, row))});
    add_squares(mesh, columns.size(), rows.size());
    return mesh;
}

Mesh mesh_of(const PlotSurface& surface, const Point3& size) {
    const auto share = [](double value, double low, double high) { return high > low ? (value - low) / (high - low) : 0; };
    double low = INFINITY, high = -INFINITY;
    for (const double z : surface.z)
        if (std::isfinite(z)) {
            low = std::min(low, z);
            high = std::max(high, z);
        }
    Mesh mesh;
    mesh.vertices.reserve(surface.z.size());
    for (std::size_t row = surface.y.size(); row-- > 0;)
        for (std::size_t column = 0; column < surface.x.size(); ++column)
            mesh.vertices.push_back(
                {size.x * share(surface.x[column], surface.x.front(), surface.x.back()),
                 size.y * share(surface.y[row], surface.y.front(), surface.y.back()),
                 std::isfinite(surface.at(column, row)) ? size.z * share(surface.at(column, row), low, high) : NAN});
    add_squares(mesh, surface.x.size(), surface.y.size());
    return mesh;
}

EnoughFacets enough_facets(const HeightMap& map, double resolution) {
    EnoughFacets enough;
    if (map.columns < 2 || map.rows < 2) return enough;
    const auto cells = [&](int every) { return std::pair(kept_of(map.columns, every), kept_of(map.rows, every)); };
    // An error may fall again with coarser facets, as those may fit the ground's own period: the coarsest that fit are looked
    // for.
    int every = std::max(map.columns, map.rows) - 1;
    for (; every > 1; every = std::min(every - 1, every * 9 / 10)) {
        const auto [columns, rows] = cells(every);
        if (error_of(map, columns, rows, resolution) < resolution) break;
    }
    enough.every = std::max(every, 1);
    const auto [columns, rows] = cells(enough.every);
    enough.error = error_of(map, columns, rows, INFINITY);
    enough.facets = facets_of_grid(columns.size(), rows.size());
    enough.of_all = facets_of_grid(static_cast<std::size_t>(map.columns), static_cast<std::size_t>(map.rows));
    const auto whole = [](std::size_t count) { return std::to_string(count); };
    enough.words = enough.every == 1 ? phrase("all {0} facets are kept: fewer would be further off than {1} mm",
                                              whole(enough.of_all), numeral(resolution))
                                     : phrase(
                                           "{0} of {1} facets are enough for a device that tells {2} mm: one height in {3} along "
                                           "each side, and none that was dropped is further off than {4} mm",
                                           whole(enough.facets), whole(enough.of_all), numeral(resolution),
                                           std::to_string(enough.every), numeral(std::ceil(enough.error * 1e4) / 1e4));
    return enough;
}

}  // namespace tactics
