// SPDX-License-Identifier: Apache-2.0
// Lengths are millimetres everywhere inside; numbers are read and written without the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tactics {

inline constexpr double kMmPerInch = 25.4;
inline constexpr double kMmPerPoint = kMmPerInch / 72.0;  ///< PostScript point

/// A finite decimal number that fills the whole of `text` ("1.5", "-2", "1e3"), or nothing.
std::optional<double> parse_number(std::string_view text);

/// A length with or without unit (mm, cm, m, km, in, ft, pt; none = mm) in mm, or nothing: "12", "1.2cm", "0.5in".
std::optional<double> parse_length(std::string_view text);

/// Shortest text that reads back to within 1e-6 of the value: "0.5", "12", "-3.25".
std::string to_text(double value);

}  // namespace tactics
