// SPDX-License-Identifier: Apache-2.0
// A model from above, from the front and from the side, and cut through, beside each other and equally large.
#pragma once

#include "tactics/solid/fold_out.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The front view lies below the one from above, and the one from the right-hand side beside it (ISO 5456-2, third angle); in the
/// fourth place is the cut by a plane parallel to the front, without the things behind it. Each has its title, "top", "front",
/// "side" or "section", as a name above it. Nothing is folded or simplified. A name stands in the first view in which its object
/// can be felt; an object has a region in each view. Outlines take precedence over creases where there is no room for both: lines
/// keep the medium's gap, except where they meet. Errors as fold_out.
FoldOut views_of(const Model& model, double width, double height, const Medium& medium, const FoldWish& wish,
                 std::vector<Phrase>& notes);

}  // namespace tactics
