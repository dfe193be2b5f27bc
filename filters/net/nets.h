// SPDX-License-Identifier: Apache-2.0
// Where the weights of the contour net are found. They are a file of their own, with terms of their own (weights/*.NOTICE): the
// program does without it.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "filters/net/net.h"

namespace tactics {

/// The first net that is in one of the folders, or nullptr. Throws Error(failed) when a file is there but cannot be used.
std::shared_ptr<const ContourNet> find_net_in(std::span<const std::string> folders);

/// Looks in the folder that TACTICS_NETS names, then where the program has its nets. Read once; any thread may ask.
std::shared_ptr<const ContourNet> find_net();

}  // namespace tactics
