// SPDX-License-Identifier: Apache-2.0
// Where the running program lies, and the library if it is one: what belongs to them is looked for beside them.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

/// The folder of the program's file, without a slash at its end; empty if the system does not say.
std::string folder_of_program();

/// The folder of the file that holds this code: the program, or a shared library in it, such as libtactics.so in Python. Without
/// a slash at its end; empty if the system does not say.
std::string folder_of_library();

/// The path of a program that only ours starts. It is looked for in the folder that the variable TACTICS_PROGRAMS names, beside
/// the program or the library, as in a build folder, and where it is installed. Empty: it is not there.
std::string own_program(std::string_view name);

}  // namespace tactics
