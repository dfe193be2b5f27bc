// SPDX-License-Identifier: Apache-2.0
// Scripts that complete the command line in a shell, made from all descriptions.
#pragma once

#include <string>

namespace tactics {

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace tactics
