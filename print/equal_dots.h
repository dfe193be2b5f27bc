// Dots that are equally far apart in both directions, as embossers draw pictures.
#pragma once

#include <string_view>

#include "print/format.h"

namespace tactics {

/// Raster and braille for a pitch of "1.6", "2.0" or "2.5" mm.
DotSetting equal_dots(std::string_view pitch, Point first);

}  // namespace tactics
