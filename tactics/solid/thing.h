// SPDX-License-Identifier: Apache-2.0
// Parts that a hand takes for one thing.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/part.h"

namespace tactics {

/// Parts that touch and belong to the same object, or to objects of the same one, are one thing: the number of its first part,
/// for each part.
std::vector<std::uint32_t> things_of(const Model& model, const std::vector<ModelPart>& parts);

}  // namespace tactics
