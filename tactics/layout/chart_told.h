// SPDX-License-Identifier: Apache-2.0
// What of a chart is not drawn as it was, whichever kind of file it came from.
#pragma once

#include <cstddef>

#include "tactics/text/phrase.h"

namespace tactics {

/// So many lines of a grid are left out, which dashes or a pale colour tell from curves.
Phrase told_of_grid(std::size_t lines);

/// So many curves are drawn through the middle of their noise.
Phrase told_of_noise(std::size_t curves);

}  // namespace tactics
