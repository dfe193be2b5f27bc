// SPDX-License-Identifier: Apache-2.0
// Places of a model without the last digits of its file.
#pragma once

#include "tactics/model.h"

namespace tactics {

/// The same model, no place moved along an axis by more than 2.2 millionths of the extent: numbers of one axis that differ by
/// less and have nothing else near them are one number, and a number that is as near to one of few decimals is that one; of how
/// few, depends on whether nearly all numbers of the axis have so few. What was meant to be in one plane, or equally long, then
/// is, whatever program wrote the file. Dense meshes stay as they are. Takes time in proportion to the vertices, but for sorting.
Model settled(Model model);

}  // namespace tactics
