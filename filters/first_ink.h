// SPDX-License-Identifier: Apache-2.0
// Where a picture begins to be drawn, below its title.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// The beginning of the first thing other than a frame around the whole, in percent of the height from the top; 100: there is
/// nothing. Of a grey picture whose words are painted over. A line along the top alone is the first thing: that of a box.
double first_ink(const Image& grey);

}  // namespace tactics
