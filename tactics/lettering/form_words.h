// SPDX-License-Identifier: Apache-2.0
// All lettering of a picture, read by the letters of the few fonts that it is in.
#pragma once

#include <vector>

#include "tactics/lettering/form_line.h"

namespace tactics {

/// One for each strip; none at all where no font is installed. Fonts are chosen by what the other reader made of the lines, or,
/// where that fits none, by what they look like.
std::vector<FormWords> read_in_fonts(const std::vector<InkStrip>& strips, const std::vector<OtherReading>& others,
                                     const PrintFonts& fonts);

}  // namespace tactics
