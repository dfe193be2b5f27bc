// SPDX-License-Identifier: Apache-2.0
#include "filters/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace tactics {

namespace {

constexpr double kTickRounding = 1e-9;  // of a step: a value that is on a tick but for rounding is on it

Ticks even(double low, double high, int most) {
    if (!(high - low >
          kTickRounding * std::max(std::abs(low), std::abs(high)))) {  // one value: something round on both sides of it
        const double room = low == 0 ? 1 : std::abs(low) / 2;
        low -= room;
        high += room;
    }
    for (double power = std::pow(10, std::floor(std::log10((high - low) / most)));; power *= 10)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double step = digit * power;
            double first = std::ceil(low / step - kTickRounding), last = std::floor(high / step + kTickRounding);
            if (last - first + 1 > most) continue;
            const bool inside = last - first >= 1;
            if (!inside) {
                first = std::floor(low / step + kTickRounding);
                last = std::ceil(high / step - kTickRounding);
            }
            std::vector<double> ticks;
            for (double k = first; k <= last; ++k) ticks.push_back(k * step);
            return {std::min(low, ticks.front()), std::max(high, ticks.back()), ticks};
        }
}

// The first value of 10^n times `digits` at or below `low`, and all up to the first at or above `high`.
std::vector<double> of_decades(double low, double high, std::span<const double> digits) {
    std::vector<double> ticks;
    for (double n = std::floor(std::log10(low)) - 1;; ++n)
        for (const double digit : digits) {
            const double tick = digit * std::pow(10, n);
            if (tick <= low * (1 + kTickRounding)) ticks.clear();
            ticks.push_back(tick);
            if (tick >= high * (1 - kTickRounding) && ticks.size() > 1) return ticks;
        }
}

}  // namespace

Ticks ticks_for(double low, double high, bool logarithmic, int most) {
    if (!logarithmic) return even(low, high, most);
    const auto room = static_cast<std::size_t>(most);
    constexpr std::array kHalves{1.0, 2.0, 5.0};
    constexpr std::array kThirds{1.0, 3.0};
    for (const std::span<const double> digits : {std::span<const double>(kHalves), std::span<const double>(kThirds)}) {
        std::vector<double> inside = of_decades(low, high, digits);
        const auto around = inside;
        std::erase_if(inside, [&](double tick) { return tick < low * (1 - kTickRounding) || tick > high * (1 + kTickRounding); });
        if (inside.size() > room) continue;
        if (inside.size() >= 2) return {std::min(low, inside.front()), std::max(high, inside.back()), inside};
        if (around.size() <= room) return {around.front(), around.back(), around};
    }
    for (int every = 1;; ++every) {  // of four multiples of `every` two at least are such of the next
        std::vector<double> inside;
        for (double n = every * std::ceil(std::log10(low) / every - kTickRounding); n <= std::log10(high) + kTickRounding;
             n += every)
            inside.push_back(std::pow(10, n));
        if (inside.size() <= room) return {std::min(low, inside.front()), std::max(high, inside.back()), inside};
    }
}

}  // namespace tactics
