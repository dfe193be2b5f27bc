// SPDX-License-Identifier: Apache-2.0
// What a drawn picture shows that has a form of its own on a page: heads of arrows, dashed lines, filled points, bars, fills. A
// finger knows them by that form, so they are looked for first and drawn as such; what is left is drawn by the recipe.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/box.h"
#include "tactics/image.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// In mm, from the picture's left and top.
struct KnownParts {
    /// Role::arrow: a head, from barb to tip to barb; Role::dash, Role::dots: such a line, whole; Role::line: a noisy curve, a
    /// stem or cap of an error bar, a tick, a side of a bar (tactics/layout/felt_bars.h).
    std::vector<Stroke> strokes;
    std::size_t noisy = 0;       ///< of the strokes: curves through the middle of their noise (noisy_curves.h)
    std::size_t marks = 0;       ///< kinds of points of a plot
    std::size_t grid_lines = 0;  ///< pale ones, which are left out (pale_grid.h)
    std::size_t left_out = 0;    ///< colours of pale surfaces behind curves (pale_fills.h)
    std::vector<Area> areas;     ///< Role::symbol: a point, each kind of a plot with a symbol of its own (inked_marks.h); with a
                                 ///< texture: a surface

    void add_to(Drawing& drawing) &&;
    std::vector<Phrase> told() const;  ///< what a reader of the picture would not expect
};

/// Takes them out of the picture, which has its size in mm; the lines that heads and points were on stay whole. If
/// `ground`, the colour of the ground, is given, surfaces of other colours get textures, too (inked_fills.h): for who draws both
/// sides of every line and outlines of surfaces.
/// `print`, pixels: where print may be that stays in the picture, and is no point of a plot.
KnownParts take_known_parts(Image& picture, const std::optional<std::array<int, 3>>& ground = {},
                            const std::vector<Box>& print = {});

}  // namespace tactics
