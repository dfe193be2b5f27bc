// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/number.h"

#include <array>
#include <charconv>
#include <cmath>

namespace tactics {

std::optional<double> parse_number(std::string_view text) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string to_text(double value) {
    if (!std::isfinite(value)) return "0";
    value = std::round(value * 1e6) / 1e6;
    if (value == 0) return "0";  // also turns -0 into 0
    std::array<char, 64> buffer{};
    const auto [end, fault] = std::abs(value) < 1e15
                                  ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
                                  : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return fault == std::errc() ? std::string(buffer.data(), end) : "0";
}

}  // namespace tactics
