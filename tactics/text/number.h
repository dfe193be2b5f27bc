// SPDX-License-Identifier: Apache-2.0
// Numbers as text, read and written without the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tactics {

/// A finite decimal number that fills the whole of `text` ("1.5", "-2", "1e3"), or nothing.
std::optional<double> parse_number(std::string_view text);

/// Shortest text that reads back to within 1e-6 of the value: "0.5", "12", "-3.25".
std::string to_text(double value);

}  // namespace tactics
