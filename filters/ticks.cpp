#include "filters/ticks.h"

#include <array>
#include <cmath>
#include <span>

namespace tactics {

namespace {

constexpr double kRounding = 1e-9;  // of a step: a value that is on a tick but for rounding is on it

std::vector<double> even(double low, double high, int most) {
    if (!(high > low)) {  // one value: something round on both sides of it
        const double room = low == 0 ? 1 : std::abs(low) / 2;
        low -= room;
        high += room;
    }
    for (double power = std::pow(10, std::floor(std::log10((high - low) / most)));; power *= 10)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double step = digit * power;
            const double first = std::floor(low / step + kRounding), last = std::ceil(high / step - kRounding);
            if (last - first + 1 > most) continue;
            std::vector<double> ticks;
            for (double k = first; k <= last; ++k) ticks.push_back(k * step);
            return ticks;
        }
}

// The first value of 10^n times `digits` at or below `low`, and all up to the first at or above `high`.
std::vector<double> of_decades(double low, double high, std::span<const double> digits) {
    std::vector<double> ticks;
    for (double n = std::floor(std::log10(low)) - 1;; ++n)
        for (const double digit : digits) {
            const double tick = digit * std::pow(10, n);
            if (tick <= low * (1 + kRounding)) ticks.clear();
            ticks.push_back(tick);
            if (tick >= high * (1 - kRounding) && ticks.size() > 1) return ticks;
        }
}

}  // namespace

std::vector<double> ticks_for(double low, double high, bool logarithmic, int most) {
    if (!logarithmic) return even(low, high, most);
    constexpr std::array kAll{1.0, 2.0, 5.0};
    constexpr std::array kDecades{1.0};
    std::vector<double> ticks = of_decades(low, high, kAll);
    if (ticks.size() <= static_cast<std::size_t>(most)) return ticks;
    ticks = of_decades(low, high, kDecades);
    while (ticks.size() > static_cast<std::size_t>(most)) {  // every second one; the last is kept by going on to it
        std::vector<double> fewer;
        const double ratio = ticks[1] / ticks[0];
        for (std::size_t i = 0; i < ticks.size(); i += 2) fewer.push_back(ticks[i]);
        if (ticks.size() % 2 == 0) fewer.push_back(ticks.back() * ratio);
        ticks = std::move(fewer);
    }
    return ticks;
}

}  // namespace tactics
