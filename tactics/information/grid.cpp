// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "tactics/error.h"

namespace tactics {

namespace {

// Which of so many even parts of low to high a value is in; what is outside is in the first or the last.
std::uint16_t part_of(double value, double low, double high, int parts) {
    const double part = std::floor((value - low) / (high - low) * parts);
    return static_cast<std::uint16_t>(std::clamp(part, 0.0, parts - 1.0));
}

[[noreturn]] void no_number(std::string_view name) {
    throw Error(Fault::failed, name, phrase("one of its values is not a number, so nothing can be counted; mend the file"));
}
[[noreturn]] void no_sample(std::string_view name) {
    throw Error(Fault::failed, name, phrase("it has no samples, so there is nothing to measure"));
}

LevelGrid components(std::span<const Point3> forces, LevelGrid grid, int index, double most, std::string_view name) {
    if (forces.empty()) no_sample(name);
    std::vector<std::uint16_t> values;
    values.reserve(forces.size());
    for (const Point3& force : forces) {
        if (!is_finite(force)) no_number(name);
        values.push_back(part_of(component(force, index), -most, most, grid.levels));
    }
    grid.values = std::move(values);
    return grid;
}

}  // namespace

bool Cells::operator==(const Cells& other) const {
    return visit([&](const auto* mine) {
        return other.visit([&](const auto* others) { return std::equal(mine, mine + size(), others, others + other.size()); });
    });
}

void check_grid(const LevelGrid& grid) {
    if (grid.columns < 1 || grid.rows < 1 || grid.slices < 1 || grid.levels < 2 || grid.levels > kMostLevels)
        throw std::logic_error("a grid without cells or levels");
    const std::size_t cells =
        static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.slices);
    if (cells != grid.count()) throw std::logic_error("a grid whose values are not as many as its cells");
    const auto holds_more = [&](const auto* values) {
        constexpr int kMost = std::numeric_limits<std::remove_cvref_t<decltype(*values)>>::max();
        return kMost >= grid.levels && *std::max_element(values, values + cells) >= grid.levels;
    };
    if (grid.values.visit(holds_more)) throw std::logic_error("a grid with a value that is none of its levels");
}

double raw_bits(double cells, double levels) { return cells * std::log2(levels); }
double raw_bits(const LevelGrid& grid) { return raw_bits(static_cast<double>(grid.count()), grid.levels); }

LevelGrid grid_of(Image grey) {
    if (grey.channels != 1) throw std::logic_error("a picture in colour is no grid");
    if (grey.pixels.empty()) throw std::logic_error("a picture without pixels is no grid");
    return {grey.width, grey.height, 1, 256, std::move(grey.pixels)};
}

LevelGrid grid_of(const HeightMap& map, double low, double high, int levels, std::string_view name) {
    if (map.heights.empty()) no_sample(name);
    LevelGrid grid{map.columns, map.rows, 1, levels, {}};
    std::vector<std::uint16_t> values;
    values.reserve(map.heights.size());
    for (const float height : map.heights) {
        if (!std::isfinite(height)) no_number(name);
        values.push_back(part_of(static_cast<double>(height), low, high, levels));
    }
    grid.values = std::move(values);
    return grid;
}

LevelGrid with_levels(const LevelGrid& grid, int levels) {
    if (levels >= grid.levels) return grid;
    std::vector<std::uint16_t> fewer(static_cast<std::size_t>(grid.levels));
    for (std::size_t i = 0; i < fewer.size(); ++i)
        fewer[i] = static_cast<std::uint16_t>(i * static_cast<std::size_t>(levels) / fewer.size());
    std::vector<std::uint16_t> values(grid.count());
    grid.values.visit([&](const auto* from) {
        std::transform(from, from + values.size(), values.begin(), [&](auto value) { return fewer[value]; });
    });
    return {grid.columns, grid.rows, grid.slices, levels, std::move(values)};
}

Point3 ForceField::at(const Point3& place) const {
    struct Between {
        std::size_t from = 0, to = 0;
        double share = 0;
    };
    const auto between = [&](double mm, int count) {
        const double at = std::clamp(mm / pitch, 0.0, count - 1.0);
        const auto from = static_cast<std::size_t>(at);
        return Between{from, std::min(from + 1, static_cast<std::size_t>(count - 1)), at - static_cast<double>(from)};
    };
    const Between x = between(place.x, columns), y = between(place.y, rows), z = between(place.z, slices);
    const auto force = [&](std::size_t i, std::size_t j, std::size_t k) {
        return forces[(k * static_cast<std::size_t>(rows) + j) * static_cast<std::size_t>(columns) + i];
    };
    const auto along = [&](std::size_t j, std::size_t k) {
        return (1 - x.share) * force(x.from, j, k) + x.share * force(x.to, j, k);
    };
    const auto across = [&](std::size_t k) { return (1 - y.share) * along(y.from, k) + y.share * along(y.to, k); };
    return (1 - z.share) * across(z.from) + z.share * across(z.to);
}

ForceField resampled(const ForceField& field, int columns, int rows, int slices) {
    const auto step = [&](int before, int after) { return after > 1 ? (before - 1) * field.pitch / (after - 1) : 0.0; };
    const double across = step(field.columns, columns), down = step(field.rows, rows), deep = step(field.slices, slices);
    // Of one column the distance means nothing, but it is divided by.
    ForceField out{columns, rows, slices, across > 0 ? across : field.pitch, {}};
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) out.forces.push_back(field.at({i * across, j * down, k * deep}));
    return out;
}

LevelGrid component_of(const ForceField& field, int component, double most, int levels, std::string_view name) {
    return components(field.forces, {field.columns, field.rows, field.slices, levels, {}}, component, most, name);
}

LevelGrid component_of(std::span<const Point3> stream, int component, double most, int levels, std::string_view name) {
    return components(stream, {static_cast<int>(stream.size()), 1, 1, levels, {}}, component, most, name);
}

}  // namespace tactics
