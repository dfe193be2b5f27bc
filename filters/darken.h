// SPDX-License-Identifier: Apache-2.0
// Ink of any colour on a background of any colour.
#pragma once

#include <array>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// A grey picture: white where the picture has the colour of its ground, and darker the more a colour differs from it in one
/// channel. On a light background only darker colours count, on a dark one only lighter colours.
Image ink_on_white(const Image& picture);

/// The same for each channel by itself: a dark line between two surfaces of any colour differs from both in one of them.
std::vector<Image> inks_on_white(const Image& picture);

/// What is nearly black, whatever it stands on, as it is; the rest is pale.
Image black_ink(const Image& picture);

/// The commonest colour, or white if two fifths as much of the picture is white and that colour is painted on it; of a grey
/// picture the same level three times.
std::array<int, 3> ground_of(const Image& picture);

}  // namespace tactics
