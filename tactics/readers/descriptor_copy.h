// SPDX-License-Identifier: Apache-2.0
// Bytes in memory as a file that another program can open.
#pragma once

#include <cstdio>
#include <memory>

namespace tactics {

/// A temporary file without a name; null where there is no room for it.
std::unique_ptr<std::FILE, int (*)(std::FILE*)> with_descriptor(std::FILE* from);

}  // namespace tactics
