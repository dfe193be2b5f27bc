// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/spoken_value.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace tactics {

namespace {

constexpr double kShare = 1.0 / 500;
constexpr int kMostDecimals = 6;
constexpr double kLargestWhole = 1e15;

// -308 to 308.
int decimals_of(double step) {
    if (!(step > 0) || !std::isfinite(step)) return kMostDecimals;
    // The 1e-9 keeps a step of 0.001 at three decimals, although its logarithm may be a hair below -3.
    return -static_cast<int>(std::floor(std::log10(step) + 1e-9));
}

std::string fixed(double value, int decimals) {
    if (decimals < 0) {
        const double unit = std::pow(10.0, -decimals);
        value = std::round(value / unit) * unit;
    }
    std::array<char, 400> digits{};
    const auto [end, fault] =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, std::clamp(decimals, 0, 15));
    std::string text(digits.data(), fault == std::errc() ? end : digits.data());
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

}  // namespace

double telling_step(const AxisSpan& span, bool logarithmic, double value) {
    const double share = span.mm > 0 ? std::max(kShare, span.resolution / span.mm) : kShare;
    if (logarithmic && span.from > 0 && span.to > 0) {
        const double ratio = std::max(span.from, span.to) / std::min(span.from, span.to);
        return std::abs(value) * (std::pow(ratio, share) - 1);
    }
    return std::abs(span.to - span.from) * share;
}

Phrase spoken_number(double value, double step, double largest) {
    if (!std::isfinite(value)) return phrase("not known");
    const int decimals = decimals_of(step);
    const double size = std::max(std::abs(value), std::abs(largest));
    const bool small = decimals > kMostDecimals && size < 1, large = size >= kLargestWhole;
    if ((!small && !large) || !std::isfinite(size)) return numeral_of(fixed(value, std::min(decimals, 15)));
    const int power = 3 * static_cast<int>(std::floor(std::log10(size) / 3));
    const std::string figure = fixed(value / std::pow(10.0, power), decimals + power);
    if (figure == "0" || power == 0) return numeral_of(figure);
    return power < 0 ? phrase("{0} times 10 to the minus {1}", numeral_of(figure), std::to_string(-power))
                     : phrase("{0} times 10 to the {1}", numeral_of(figure), std::to_string(power));
}

Phrase spoken_date(double seconds, double step) {
    using namespace std::chrono;
    constexpr double kFarthest = 9e11;  // s: years of five digits, within what std::chrono::year holds
    constexpr double kDay = 86'400, kMinute = 60;
    if (!std::isfinite(seconds) || std::abs(seconds) > kFarthest) return spoken_number(seconds, step, seconds);
    const int decimals = step < 1 ? std::min(decimals_of(step), kMostDecimals) : 0;
    const double ticks = std::pow(10.0, decimals);
    // To the nearest tick, as 0.1 s is no number of the processor, then downwards.
    const auto all = static_cast<long long>(step < 1 ? std::round(seconds * ticks) : std::floor(seconds + 1e-6));
    const auto a_second = static_cast<long long>(ticks), a_day = 86'400 * a_second;
    const long long day = (all >= 0 ? all : all - a_day + 1) / a_day, of_day = all - day * a_day;
    const year_month_day date{sys_days{days{static_cast<int>(day)}}};
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                  static_cast<unsigned>(date.day()));
    std::string words = text.data();
    if (step >= kDay) return words;
    const long long whole = of_day / a_second;
    std::snprintf(text.data(), text.size(), " %02d:%02d", static_cast<int>(whole / 3600), static_cast<int>(whole / 60 % 60));
    words += text.data();
    if (step >= kMinute) return words;
    const std::string part = fixed(static_cast<double>(whole % 60) + static_cast<double>(of_day % a_second) / ticks, decimals);
    return words + (part.find('.') == 1 || part.size() == 1 ? ":0" : ":") + part;
}

}  // namespace tactics
