// SPDX-License-Identifier: Apache-2.0
// How complete the lines of a page are: a line with a loose end encloses nothing.
#pragma once

#include <cstddef>

#include "tactics/drawing.h"

namespace tactics {

struct WholeLines {
    std::size_t lines = 0;
    double length = 0;  ///< mm
    std::size_t loose_ends = 0;
    double whole = 0;  ///< mm of lines that have none
};

/// An end of an open line is loose if no other line, no end of its own line (one longer than four times `reach`) and no side of
/// the rectangle around all lines is within `reach` mm of it. Outlines of areas are closed lines. Only lines of the subject
/// count.
WholeLines whole_lines(const Drawing& drawing, double reach = 4);

}  // namespace tactics
