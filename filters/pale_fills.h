// SPDX-License-Identifier: Apache-2.0
// Pale surfaces behind curves, such as the histogram that a density is drawn on.
#pragma once

#include <cstddef>

#include "tactics/image.h"

namespace tactics {

/// Gives the ground's colour to surfaces of a pale colour whose border a curve runs along, so near that nothing but scraps of
/// that border would be left beside it. Returns of how many colours they were. The picture has its size in mm.
std::size_t leave_out_pale_fills(Image& picture);

}  // namespace tactics
