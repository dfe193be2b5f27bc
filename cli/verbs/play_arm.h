// SPDX-License-Identifier: Apache-2.0
// What is played on an arm, felt with a fingertip in space: the plot of a table, a relief, a model.
#pragma once

#include <span>
#include <string_view>

#include "cli/command.h"

namespace tactics {

/// The options of play that are about arms alone, and are refused with a mouse.
std::span<const std::string_view> arm_flags();

/// Throws Error. Gives the exit code.
int play_on_arm(const Given& given);

}  // namespace tactics
