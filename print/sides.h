// SPDX-License-Identifier: Apache-2.0
// Machines that emboss both sides of a sheet.
#pragma once

#include "tactics/option.h"

namespace tactics {

/// Option of a machine or format that supports backs: --duplex sets it to both.
inline constexpr Option kSides{.name = "sides",
                               .type = Option::Type::choice,
                               .fallback = 0,
                               .min = 0,
                               .max = 1,
                               .summary = "of a sheet: both for pages that are front and back by turns",
                               .choices = "one both"};

inline bool on_both(const Settings& settings) { return settings.choice("sides") == "both"; }

}  // namespace tactics
