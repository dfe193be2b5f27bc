// SPDX-License-Identifier: Apache-2.0
// Bytes in memory as a file that another program can open.
#pragma once

#include "tactics/transport/temporary_file.h"

namespace tactics {

/// A temporary file without a name; null where there is no room for it.
TemporaryFile with_descriptor(std::FILE* from);

}  // namespace tactics
