// SPDX-License-Identifier: Apache-2.0
// Files that are taken as they are.
#pragma once

#include <string>

namespace tactics {

/// Puts a file behind what is there; "-" is standard input. A pipe can be read once only. Throws Error: not there, cannot be read
/// to its end, over 256 MB together.
void append_file(std::string& bytes, const std::string& name);

}  // namespace tactics
