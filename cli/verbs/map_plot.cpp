// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/map_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tactics {

namespace {

// So many of a row or column, evenly, with its first and its last.
std::vector<int> samples_of(int count, int most) {
    const int kept = std::min(count, std::max(most, 2));
    std::vector<int> samples;
    for (int i = 0; i < kept; ++i)
        samples.push_back(static_cast<int>(std::lround(1.0 * i * (count - 1) / std::max(kept - 1, 1))));
    return samples;
}

}  // namespace

Plot plot_of_map(const HeightMap& map, int most_samples) {
    Plot plot{"", {"across, mm"}, {"up, mm"}, {}, {}};
    plot.z = {"height, mm"};
    if (map.columns < 2 || map.rows < 2) return plot;
    const double fewer = std::min(1.0, 1.0 * most_samples / std::max(map.columns, map.rows));
    const auto along = [&](int count) { return samples_of(count, static_cast<int>(std::ceil(fewer * count))); };
    const std::vector<int> columns = along(map.columns);
    std::vector<int> rows = along(map.rows);
    std::reverse(rows.begin(), rows.end());
    PlotSurface surface;
    for (const int column : columns) surface.x.push_back((column + 0.5) * map.pitch);
    for (const int row : rows) surface.y.push_back(map.height() - (row + 0.5) * map.pitch);
    for (const int row : rows)
        for (const int column : columns) surface.z.push_back(static_cast<double>(map.at(column, row)));
    plot.surfaces.push_back(std::move(surface));
    return plot;
}

}  // namespace tactics
