// SPDX-License-Identifier: Apache-2.0
// The classic syntax: VRML97, VRML 1.0, Open Inventor's text, and X3D with braces.
#pragma once

#include <string>
#include <string_view>

#include "tactics/readers/vrml/world.h"

namespace tactics {

/// `bytes` begin with a header such as "#VRML V2.0 utf8". Unknown nodes and fields are read like all others. Throws Error(failed)
/// at FILE:LINE for invalid syntax, a truncated file, or passed limits of world.h.
World read_classic_world(std::string_view bytes, const std::string& file);

}  // namespace tactics
