// SPDX-License-Identifier: Apache-2.0
// Lines that are too pale to be ink beside the others.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// How much of the middles of lines one cut between ink and ground loses, in longer sides of the picture: grey curves beside
/// black ones, hatches beside frames. Level and upright lines are not counted: most are a grid.
double pale_strokes(const Image& picture);

}  // namespace tactics
