// SPDX-License-Identifier: Apache-2.0
// Ink of any colour on a ground of any colour.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Grey: white where the picture has its commonest colour, and the darker the more a colour differs from that in one channel. Of
/// a light ground only what is darker counts, of a dark one only what is lighter.
Image ink_on_white(const Image& picture);

}  // namespace tactics
