// SPDX-License-Identifier: Apache-2.0
// Surfaces of a drawn picture by what they are filled with: one colour, or a hatch. Where a drawing has several fills, they say
// which surface is what.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// Surfaces of other colours than the ground's that have room for a texture, each with one of its own for each kind of fill;
/// their outlines are left to whoever draws the picture. Places in mm. Empty where one colour is all there is, or where there are
/// more kinds than textures. Hatches are painted over in the picture with their mean, up to their outline, so that their lines
/// are not drawn.
std::vector<Area> take_fills(Image& picture, const std::array<int, 3>& ground);

/// Without the surfaces of the fill that is around all others: along three tenths of the picture's frame or more.
std::vector<Area> without_ground_around(std::vector<Area> areas, double width, double height);

/// A place in the widest surface that is hatched, in pixels, if all that are have the same hatch. The picture need not have its
/// size: it is taken to fill a page.
std::optional<Point> hatched_place(const Image& picture);

}  // namespace tactics
