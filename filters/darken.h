// SPDX-License-Identifier: Apache-2.0
// Ink of any colour on a background of any colour.
#pragma once

#include <array>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// A grey picture: white where the picture has its commonest colour, and darker the more a colour differs from it in one channel.
/// On a light background only darker colours count, on a dark one only lighter colours.
Image ink_on_white(const Image& picture);

/// The same for each channel by itself: a dark line between two surfaces of any colour differs from both in one of them.
std::vector<Image> inks_on_white(const Image& picture);

/// The commonest colour; of a grey picture the same three times.
std::array<int, 3> ground_of(const Image& picture);

}  // namespace tactics
