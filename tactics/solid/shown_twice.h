// SPDX-License-Identifier: Apache-2.0
// Sides of a model that a layout shows in two places.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/layout.h"

namespace tactics {

/// The hinges whose two panels are both laid out, but apart.
std::vector<std::uint32_t> shown_twice(const FlatLayout& layout, const Panels& panels, double touching);

}  // namespace tactics
