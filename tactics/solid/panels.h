// SPDX-License-Identifier: Apache-2.0
// The panels, hinges and bars of a model.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/panel.h"

namespace tactics {

/// `thing` says of each part which thing it belongs to: only parts of one thing are hinged to each other.
Panels panels_of(const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing, const ViewPlane& view);

}  // namespace tactics
