// SPDX-License-Identifier: Apache-2.0
// Classifies a value of a table: a number, a gap, or neither.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace tactics {

/// The decimal separator.
enum class Decimal : std::uint8_t { point, comma };

/// A gap: empty, or NaN, NA, N/A, null in any case, or "-".
bool is_gap(std::string_view cell);

bool is_infinity(std::string_view cell);

/// A finite number with that decimal separator and no thousands separators.
std::optional<double> number_in(std::string_view cell, Decimal decimal);

/// With either mark.
bool is_number(std::string_view cell);

/// Digits with marks between each three: "1,234,567", "1.234,5", "12,345". The last may be a number with a decimal comma, too.
bool has_thousands(std::string_view cell);

}  // namespace tactics
