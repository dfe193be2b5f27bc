// SPDX-License-Identifier: Apache-2.0
// The forms that plotting tools give to points, and which of the symbols that a finger knows stands for which.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tactics/image.h"
#include "tactics/plot.h"

namespace tactics {

enum class MarkForm : std::uint8_t {
    disc,
    square,
    diamond,
    triangle,
    star,
    ring,
    open_square,
    open_diamond,
    open_triangle,
    plus,
    cross,
    asterisk
};

/// `share`: grey, 255 where all of a pixel is ink; ground on all sides. Triangles may point anywhere along the axes. Nothing if
/// it is none of them.
std::optional<MarkForm> mark_form_of(const Image& share);

/// One for each kind, all different as long as there are no more kinds than symbols, and each as near to its form as that allows.
/// Kinds of the same form, as of two colours, get different ones, too.
std::vector<PlotSymbol> symbols_for(const std::vector<MarkForm>& kinds);

}  // namespace tactics
