// SPDX-License-Identifier: Apache-2.0
// A model from above, from the front and from the side, beside each other and equally large.
#pragma once

#include "tactics/solid/fold_out.h"

namespace tactics {

/// The front view lies below the one from above, and the one from the right-hand side beside it (ISO 5456-2, third angle).
/// Nothing is folded. A name stands in the first view in which its object is seen. Errors as fold_out.
FoldOut views_of(const Model& model, double width, double height, const Medium& medium, const FoldWish& wish,
                 std::vector<std::string>& notes);

}  // namespace tactics
