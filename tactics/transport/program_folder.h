// SPDX-License-Identifier: Apache-2.0
// The folder of the running program, or of the library, beside which its files are found.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

/// The folder of the program's file, without a slash at its end; empty if the system does not say.
std::string folder_of_program();

/// The folder of the file that holds this code: the program, or a shared library in it, such as libtactics.so in Python. Without
/// a slash at its end; empty if the system does not say.
std::string folder_of_library();

/// The path of a program that only this project starts; empty if it is not found. Searched are the folder in the environment
/// variable TACTICS_PROGRAMS, the folder of the program or library (as in a build tree), and the installed folder.
std::string own_program(std::string_view name);

}  // namespace tactics
