// SPDX-License-Identifier: Apache-2.0
// The program's side of the OpenImageIO module: it is looked for and opened when it is first needed.
#pragma once

#include <string>

#include "tactics/readers/module/openimageio.h"

namespace tactics {

/// Throws Error(failed) at `place` if it is not installed or of another version.
const TacticsOiio& openimageio_module(const std::string& place);

}  // namespace tactics
