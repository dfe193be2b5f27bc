// SPDX-License-Identifier: Apache-2.0
// What two readings of one picture have found, put together.
#pragma once

#include "tactics/lettering/lettering.h"

namespace tactics {

/// Both are of the same picture, `smoothed` without its noise. Where both have found print, what is sure in one of them is so if
/// the other one reads the same, or a part of it that is no part of a number, sure or not; else nothing there is sure. Where only
/// one has found print, a letter by itself is not sure. Letters alone, three or more, that both read with high sureness are sure.
Lettering put_together(Lettering given, Lettering smoothed);

}  // namespace tactics
