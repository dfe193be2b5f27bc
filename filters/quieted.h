// SPDX-License-Identifier: Apache-2.0
// Grain of a scan or of a camera, which would be taken for marks of a drawing.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Smooths noise away where there is any, and keeps borders sharp. A picture without noise stays as it is, to the bit.
void quieten(Image& picture);

/// Less of it, so that no pale line goes with it, nor the thin part of a letter. False: there is no noise.
bool quieten_lines(Image& picture);

}  // namespace tactics
