// SPDX-License-Identifier: Apache-2.0
// What is to be felt, before it is known on what: heights on a grid, with what is known of them.
#pragma once

#include <optional>
#include <string_view>

#include "tactics/drawing.h"
#include "tactics/information/measures.h"
#include "tactics/information/pyramid.h"

namespace tactics {

struct MeasuredScene {
    Pyramid pyramid;
    Measures measures;
    double width = 0, height = 0;  ///< mm
    double low = 0, high = 0;      ///< mm that the lowest and the highest level stand for
    std::optional<Drawing> lines;  ///< nothing: it is no drawing; as large as the scene

    bool is_drawn() const { return lines.has_value(); }
    /// mm that lie between one level and the next.
    double step() const { return (high - low) / pyramid.whole().levels; }
};

/// Heights of a map, a picture or a model, from low to high (mm). Throws Error(failed): all of one height, for then there is
/// nothing to be felt. `name` is the file's, for messages.
MeasuredScene scene_of(LevelGrid grid, double pitch, double low, double high, std::string_view name);
/// A drawing in black (1) on white (0), as a grid of such cells. Throws Error(failed): nothing is drawn.
MeasuredScene scene_of(LevelGrid grid, double pitch, Drawing lines, std::string_view name);

}  // namespace tactics
