// SPDX-License-Identifier: Apache-2.0
// What the dashes of a figure's lines say: which line is which.
#pragma once

#include <string_view>

#include "tactics/readers/svg/found_page.h"

namespace tactics {

/// The marks of a dash pattern as SVG writes it, for a line of that width: stroke-dasharray and stroke-width, in one unit.
DashMarks marks_of(std::string_view dashes, std::string_view width);

/// If lines of a figure have different marks, dotted ones get Role::dots and those of dashes and dots are heavy, so that a finger
/// tells them apart, too. If all have the same, they stay dashed, whatever their marks are.
void tell_dashes_apart(FoundPage& figure);

}  // namespace tactics
