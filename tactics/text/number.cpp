// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace tactics {

namespace {

// Most numbers of a table are short decimals: whole numbers that a double holds exactly, divided by a power of ten that it holds
// exactly, too, so that the quotient is rounded once and is the nearest (W. D. Clinger, PLDI 1990). False: it is not one.
bool read_short_decimal(std::string_view text, double& value) {
    constexpr std::size_t kMostDigits = 15;  // below 2^53
    static constexpr std::array<double, kMostDigits + 1> kPowers = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                                    1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char *at = text.data(), *const end = at + text.size();
    const bool minus = at != end && *at == '-';
    if (minus) ++at;
    std::uint64_t whole = 0;
    const auto take_digits = [&] {
        const char* const begin = at;
        for (; at != end; ++at) {
            const unsigned digit = static_cast<unsigned char>(*at) - unsigned{'0'};
            if (digit > 9) break;
            whole = 10 * whole + digit;
        }
        return static_cast<std::size_t>(at - begin);
    };
    if (text.size() > kMostDigits + 2) return false;
    std::size_t digits = take_digits(), decimals = 0;
    if (at != end && *at == '.') {
        ++at;
        decimals = take_digits();
        digits += decimals;
    }
    if (at != end || digits == 0 || digits > kMostDigits) return false;
    value = static_cast<double>(whole) / kPowers[decimals];
    if (minus) value = -value;
    return true;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double value = 0;
    if (read_short_decimal(text, value)) return value;
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
