// SPDX-License-Identifier: Apache-2.0
// A figure that was drawn with lines, as a drawing to be laid out.
#pragma once

#include "tactics/readers/svg/svg.h"

namespace tactics {

/// The lines and surfaces of a figure (SvgPurpose::figure) in a drawing of that width, without its words. Lines are as thin or
/// thick as they are to each other: most of the ink is normal.
Drawing drawing_of_figure(const FoundPage& figure, double width);

}  // namespace tactics
