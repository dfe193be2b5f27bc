// SPDX-License-Identifier: Apache-2.0
// Appends unchanged files.
#pragma once

#include <string>

namespace tactics {

/// Appends a file to the contents so far; "-" is standard input. A pipe can be read only once. Throws Error if it is missing,
/// cannot be read to its end, or exceeds 256 MB in total.
void append_file(std::string& bytes, const std::string& name);

}  // namespace tactics
