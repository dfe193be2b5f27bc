// SPDX-License-Identifier: Apache-2.0
#include "tactics/units.h"

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

std::optional<double> parse_length(std::string_view text) {
    struct Unit {
        std::string_view name;
        double mm;
    };
    static constexpr std::array<Unit, 7> kUnits{
        {{"mm", 1}, {"cm", 10}, {"km", 1e6}, {"m", 1e3}, {"in", kMmPerInch}, {"ft", 12 * kMmPerInch}, {"pt", kMmPerPoint}}};
    for (const auto& unit : kUnits) {
        if (text.size() > unit.name.size() && text.substr(text.size() - unit.name.size()) == unit.name) {
            const auto value = parse_number(text.substr(0, text.size() - unit.name.size()));
            if (!value) return std::nullopt;
            return *value * unit.mm;
        }
    }
    return parse_number(text);
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
