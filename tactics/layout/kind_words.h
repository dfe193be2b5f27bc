// SPDX-License-Identifier: Apache-2.0
// The heights of the lines of a page in words.
#pragma once

#include "tactics/kind_heights.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Of each kind that is there: "the drawing and braille: 100 %, grid lines: 50 %".
Phrase words_of(const KindHeights& heights);

}  // namespace tactics
