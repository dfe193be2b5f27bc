// SPDX-License-Identifier: Apache-2.0
// Finds the weights of the contour net. They are a separate file with its own terms (weights/*.NOTICE); the program works without
// it.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "filters/net/net.h"

namespace tactics {

/// The first net found in one of the folders, or nullptr. Throws Error(failed) if a file exists but cannot be used.
std::shared_ptr<const ContourNet> find_net_in(std::span<const std::string> folders);

/// Looks in the folder that TACTICS_NETS names, then in the program's own. Read once; safe from any thread.
std::shared_ptr<const ContourNet> find_net();

}  // namespace tactics
