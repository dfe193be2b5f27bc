// SPDX-License-Identifier: Apache-2.0
// Dashed lines too short to be felt as dashed: whiskers of boxes, as R draws them.
#pragma once

#include <vector>

#include "filters/dash_rows.h"
#include "tactics/image.h"

namespace tactics {

/// Of each row, whether it is such a line, level or upright from one thing to another; or is like one, so that all are drawn in
/// the same way. `longest` in pixels.
std::vector<bool> whiskers_among(const std::vector<DashRow>& rows, double longest);

/// Draws them whole, in the colours that they had `before` their dashes were painted over; and if there are some, those that have
/// no dash of their own, only what is left of one at each end.
void join_whiskers(Image& picture, const Image& before, const Image& ink, const std::vector<DashRow>& whiskers);

}  // namespace tactics
