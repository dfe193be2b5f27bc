// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/voxels.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"

namespace tactics {

namespace {

LevelGrid grid_along(const ForceField& field, int which, const VoxelLevels& levels) {
    std::vector<std::uint16_t> values;
    values.reserve(field.forces.size());
    const double steps = (levels.levels - 1) / (levels.high - levels.low);
    for (const Point3& force : field.forces) {
        const double at = std::round((component(force, which) - levels.low) * steps);
        values.push_back(static_cast<std::uint16_t>(std::clamp(at, 0.0, levels.levels - 1.0)));
    }
    return {field.columns, field.rows, field.slices, levels.levels, std::move(values)};
}

double bits_of(const ForceField& field, const VoxelLevels& levels) {
    double bits = 0;
    for (int which = 0; which < levels.components; ++which) bits += measure(grid_along(field, which, levels), {}).bits;
    return bits;
}

double error_of(const ForceField& field, const ForceField& fewer) {
    const ForceField again = resampled(fewer, field.columns, field.rows, field.slices);
    double squares = 0;
    for (std::size_t i = 0; i < field.forces.size(); ++i) {
        const Point3 missed = field.forces[i] - again.forces[i];
        squares += dot(missed, missed);
    }
    return std::sqrt(squares / static_cast<double>(field.forces.size()));
}

int half_of(int side) { return side < 2 ? side : std::max(2, (side + 1) / 2); }

}  // namespace

MeasuredVoxels measured(const ForceField& field, const VoxelLevels& levels, bool with_details, std::string_view name) {
    if (std::adjacent_find(field.forces.begin(), field.forces.end(), std::not_equal_to<>()) == field.forces.end())
        throw Error(Fault::failed, name, phrase("all its voxels are the same, so there is nothing to measure"));
    if (!std::isfinite((levels.levels - 1) / (levels.high - levels.low)))
        throw Error(Fault::failed, name, phrase("its numbers lie too near each other to be counted; multiply them"));
    MeasuredVoxels all;
    for (int which = 0; which < levels.components; ++which) {
        all.along.push_back(measure(grid_along(field, which, levels), {}));
        all.raw += all.along.back().raw;
        all.low += all.along.back().low;
        all.high += all.along.back().high;
        all.bits += all.along.back().bits;
    }
    if (!with_details) return all;
    all.details.push_back({field.columns, field.rows, field.slices, all.bits, 0});
    for (ForceField fewer = field; std::max({fewer.columns, fewer.rows, fewer.slices}) > 2;) {
        fewer = resampled(field, half_of(fewer.columns), half_of(fewer.rows), half_of(fewer.slices));
        all.details.push_back({fewer.columns, fewer.rows, fewer.slices, std::min(bits_of(fewer, levels), all.details.back().bits),
                               error_of(field, fewer)});
    }
    return all;
}

}  // namespace tactics
