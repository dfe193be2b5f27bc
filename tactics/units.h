// SPDX-License-Identifier: Apache-2.0
// Lengths are millimetres everywhere inside; numbers are read and written without the locale.
#pragma once

#include <optional>
#include <string_view>

#include "tactics/text/number.h"

namespace tactics {

inline constexpr double kMmPerInch = 25.4;
inline constexpr double kMmPerPoint = kMmPerInch / 72.0;  ///< PostScript point

/// A length with or without unit (mm, cm, m, km, in, ft, pt; none = mm) in mm, or nothing: "12", "1.2cm", "0.5in".
std::optional<double> parse_length(std::string_view text);

}  // namespace tactics
