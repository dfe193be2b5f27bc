// SPDX-License-Identifier: Apache-2.0
// What a recipe ends with, as what is laid out.
#pragma once

#include "tactics/artwork.h"

namespace tactics {

/// A recipe may end before there are lines; then its picture is printed, in black and white.
Drawing drawing_of(Artwork artwork);

}  // namespace tactics
