// SPDX-License-Identifier: Apache-2.0
// Dashed lines as whole ones: what is looked for at the ends of lines is at theirs, too.
#pragma once

#include <vector>

#include "filters/dash_rows.h"

namespace tactics {

/// `ink`, grey, with the gaps of these rows closed, and those up to what they stop close before.
Image with_gaps_closed(Image ink, const std::vector<DashRow>& rows);

}  // namespace tactics
