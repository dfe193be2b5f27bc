// SPDX-License-Identifier: Apache-2.0
// Where a picture begins to be drawn, below its title.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Where the first thing begins, in percent of the picture.
struct FirstInk {
    double top = 100;              ///< 100: there is nothing
    double left = 0, right = 100;  ///< of what is drawn in the first kFirstPart below that
};
inline constexpr double kFirstPart = 4;  ///< percent of the height

/// Of a grey picture whose words are painted over; a frame around the whole is nothing. A line along the top alone is the first
/// thing: that of a box.
FirstInk first_ink(const Image& grey);

}  // namespace tactics
