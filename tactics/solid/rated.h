// SPDX-License-Identifier: Apache-2.0
// The rating of a layout for a reader.
#pragma once

#include "tactics/solid/layout.h"

namespace tactics {

/// Of the rating, by which one of several layouts must be better than an earlier one to be preferred.
inline constexpr double kAsGood = 1e-4;

/// A third of `shown` counts faces and bars, a third their area, a third the parts of which anything is there; something round
/// counts as three faces, something curved as two. A wedge shows a third of a bar.
Rating rating_of(const FlatLayout& layout, const std::vector<ModelPart>& parts, const Panels& panels, const ReaderWish& reader);

}  // namespace tactics
