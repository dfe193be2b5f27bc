// SPDX-License-Identifier: Apache-2.0
// A table played on an arm: its plot, upright before the person or flat, felt with a fingertip.
#pragma once

#include <span>
#include <string_view>

#include "cli/command.h"

namespace tactics {

/// The options of play that are about arms, and those that are about mice: each is refused with the other.
std::span<const std::string_view> arm_flags();
std::span<const std::string_view> mouse_flags();

/// Throws Error. Gives the exit code.
int play_on_arm(const Given& given);

}  // namespace tactics
