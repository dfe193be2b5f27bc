// SPDX-License-Identifier: Apache-2.0
// Converts the end result of a recipe to a drawing for layout.
#pragma once

#include "tactics/artwork.h"

namespace tactics {

/// If a recipe ends before there are lines, its picture is printed in black and white.
Drawing drawing_of(Artwork artwork);

}  // namespace tactics
