// SPDX-License-Identifier: Apache-2.0
// Grids behind print.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// The picture (grey) without its long thin level and upright lines that are paler than print, such as those of a grid: what is
/// printed over them is as dark as beside them, so that letters keep their shapes. Black ink on light ground only.
Image without_pale_lines(Image grey);

}  // namespace tactics
