// SPDX-License-Identifier: Apache-2.0
// Files of the container (tactics/coding/container.h), with heights or with a recording in them.
#pragma once

#include <string>

#include "tactics/coding/level_map.h"
#include "tactics/readers/read.h"

namespace tactics {

/// By its first bytes. Rewinds the source.
bool is_felt(Source& source);
/// All of it. Throws Error(failed): cannot be read.
std::string felt_bytes(Source& source);
/// Its heights. Throws Error(failed): damaged, a recording, over `most` heights.
LevelMap read_levels(Source& source, long long most);

}  // namespace tactics
