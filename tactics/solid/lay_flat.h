// SPDX-License-Identifier: Apache-2.0
// Of many layouts the one that shows most for what it asks of the reader.
#pragma once

#include "tactics/solid/layout.h"

namespace tactics {

/// How many layouts are tried beyond the strategies: as many as the wish says of up to 200 panels, and of more panels fewer in
/// proportion. It is work that is bounded and no time, so that the same model gives the same layout on every machine.
int layouts_tried(int effort, std::size_t panels);

FlatLayout lay_flat(const std::vector<ModelPart>& parts, const Panels& panels, const std::vector<std::uint32_t>& thing,
                    const ViewPlane& view, const LayoutWish& wish);

}  // namespace tactics
