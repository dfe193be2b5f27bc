// SPDX-License-Identifier: Apache-2.0
// Chooses, from many layouts, the one that shows most for the effort it asks of the reader.
#pragma once

#include "tactics/solid/layout.h"

namespace tactics {

/// The number of layouts tried besides the strategies: as many as wished for up to 200 panels, and proportionally fewer for more.
/// The limit is on work, not on time, so that the same model gives the same layout on every machine.
int layouts_tried(int effort, std::size_t panels);

FlatLayout lay_flat(const std::vector<ModelPart>& parts, const Panels& panels, const std::vector<std::uint32_t>& thing,
                    const ViewPlane& view, const LayoutWish& wish);

}  // namespace tactics
