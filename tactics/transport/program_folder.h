// SPDX-License-Identifier: Apache-2.0
// Where the running program lies: what belongs to it is looked for beside it.
#pragma once

#include <string>

namespace tactics {

/// The folder of the program's file, without a slash at its end; empty if the system does not say.
std::string folder_of_program();

}  // namespace tactics
