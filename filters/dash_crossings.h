// SPDX-License-Identifier: Apache-2.0
// The ink of dashed lines where they cross.
#pragma once

#include <vector>

#include "filters/dash_rows.h"

namespace tactics {

/// Where dashed lines cross, their dashes may be one piece of ink. It is of no other thing, so it goes to the ink of one of
/// `rows`: small, no thicker than a crossing, and right on the way of that row. `pieces` are those of `ink`.
void take_crossings(const Image& ink, const Components& pieces, const DashLimits& limits, std::vector<DashRow>& rows);

}  // namespace tactics
