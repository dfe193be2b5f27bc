// SPDX-License-Identifier: Apache-2.0
// Play on an arm, with a fingertip in space: the plot of a table, a relief, a model.
#pragma once

#include <span>
#include <string_view>

#include "cli/command.h"

namespace tactics {

/// The options of play that apply only to arms, and are refused with a mouse.
std::span<const std::string_view> arm_flags();

/// Throws Error. Returns the exit code.
int play_on_arm(const Given& given);

}  // namespace tactics
