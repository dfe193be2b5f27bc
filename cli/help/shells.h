// SPDX-License-Identifier: Apache-2.0
// Shell scripts that complete command lines, made from all descriptions.
#pragma once

#include <string>

namespace tactics {

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace tactics
