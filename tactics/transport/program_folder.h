// SPDX-License-Identifier: Apache-2.0
// Where the running program lies: what belongs to it is looked for beside it.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

/// The folder of the program's file, without a slash at its end; empty if the system does not say.
std::string folder_of_program();

/// The path of a program that only ours starts: beside it, as in a build folder, or where it is installed. Empty: it is not
/// there.
std::string own_program(std::string_view name);

}  // namespace tactics
