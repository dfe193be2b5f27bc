// SPDX-License-Identifier: Apache-2.0
// Which way a model is up. OBJ, PLY and STL do not say: tools for printing write z upwards, others, such as Blender, y.
#pragma once

#include <cstdint>

#include "tactics/model.h"

namespace tactics {

enum class UpAxis : std::uint8_t {
    of_file,  ///< as it was read
    x,
    y,
    z,
};

/// The same model with that axis of its file upwards (COLLADA is read as if it had y upwards, whichever axis it says), turned and
/// not mirrored: x stays to the right, but for `x`.
Model turned_up(Model model, UpAxis up);

}  // namespace tactics
