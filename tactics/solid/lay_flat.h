// SPDX-License-Identifier: Apache-2.0
// Of many layouts the one that shows most for what it asks of the reader.
#pragma once

#include "tactics/solid/layout.h"

namespace tactics {

FlatLayout lay_flat(const std::vector<ModelPart>& parts, const Panels& panels, const std::vector<std::uint32_t>& thing,
                    const ViewPlane& view, const LayoutWish& wish);

}  // namespace tactics
