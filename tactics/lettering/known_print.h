// SPDX-License-Identifier: Apache-2.0
// What of a picture is print for sure, for other ink to be held against.
#pragma once

#include <vector>

#include "tactics/lettering/mark_shape.h"
#include "tactics/lettering/read_line.h"

namespace tactics {

// Settings: of the height of known print.
inline constexpr double kLeastOfKnown = 0.7, kMostOfKnown = 1.4;

/// Neither read for sure nor told.
bool is_doubtful(const ReadLine& line);

/// Print that was read for sure or is told; if there is none, that which is likely.
using KnownPrint = std::vector<const LetteringLine*>;
KnownPrint known_print(const std::vector<ReadLine>& lines);
bool as_large_as_print(const MarkShape& shape, const KnownPrint& known);

}  // namespace tactics
