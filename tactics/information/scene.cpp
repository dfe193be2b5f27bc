// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/scene.h"

#include <algorithm>
#include <utility>

#include "tactics/error.h"
#include "tactics/information/felt_rate.h"

namespace tactics {

namespace {

bool is_flat(const LevelGrid& grid) {
    return grid.values.visit([&](const auto* values) {
        return std::all_of(values, values + grid.count(), [&](auto value) { return value == *values; });
    });
}

}  // namespace

MeasuredScene scene_of(LevelGrid grid, double pitch, double low, double high, std::string_view name) {
    if (is_flat(grid))
        throw Error(Fault::failed, name,
                    phrase("all of it has one height, so there is nothing to be felt or lost; take another file"));
    const double width = grid.columns * pitch, height = grid.rows * pitch;
    const Measures measures = measure(grid, kFeltHeight / ((high - low) / grid.levels));
    return {Pyramid(std::move(grid), Pooling::mean), measures, width, height, low, high, {}};
}

MeasuredScene scene_of(LevelGrid grid, double pitch, Drawing lines, std::string_view name) {
    if (is_flat(grid))
        throw Error(Fault::failed, name,
                    phrase("nothing is drawn of it that could be felt; take another {0}", spelled("recipe")));
    const double width = grid.columns * pitch, height = grid.rows * pitch;
    const Measures measures = measure(grid, {});
    return {Pyramid(std::move(grid), Pooling::highest), measures, width, height, 0, 0, std::move(lines)};
}

}  // namespace tactics
