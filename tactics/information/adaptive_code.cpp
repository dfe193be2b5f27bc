// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/adaptive_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tactics {

namespace {

// ln Gamma by Stirling's series, to 3e-12 from 16 on (DLMF 5.11.1).
double log_gamma_of_large(double z) {
    const double square = 1 / (z * z);
    return (z - 0.5) * std::log(z) - z + 0.5 * std::log(2 * std::numbers::pi) +
           (1 - square * (1.0 / 30 - square / 105)) / (12 * z);
}

// ln of Gamma(z + whole) / Gamma(z).
double log_rising(double z, double whole) {
    constexpr double kLarge = 16;
    double sum = 0;
    for (; whole > 0 && z < kLarge; --whole) sum += std::log(z++);
    return whole > 0 ? sum + log_gamma_of_large(z + whole) - log_gamma_of_large(z) : sum;
}

// ln of Gamma(c + 1/2) / Gamma(1/2); most counts are small.
double log_of_count(std::uint32_t count) {
    static const auto kTable = [] {
        std::array<double, 1024> table{};
        for (std::size_t i = 1; i < table.size(); ++i) table[i] = table[i - 1] + std::log(static_cast<double>(i) - 0.5);
        return table;
    }();
    return count < kTable.size() ? kTable[count] : log_rising(0.5, count);
}

}  // namespace

Code adaptive_code(std::span<const std::uint32_t> counts, std::size_t levels) {
    double coded = 0, learnt = 0;  // nats
    for (std::size_t from = 0; from < counts.size(); from += levels) {
        std::uint64_t all = 0;
        for (const std::uint32_t count : counts.subspan(from, levels)) {
            if (count == 0) continue;
            all += count;
            coded -= log_of_count(count);
            learnt -= count * std::log(static_cast<double>(count));
        }
        if (all == 0) continue;
        const auto n = static_cast<double>(all);
        coded += log_rising(static_cast<double>(levels) / 2, n);
        learnt += n * std::log(n);
    }
    return {std::max(0.0, coded / std::numbers::ln2), std::max(0.0, learnt / std::numbers::ln2)};
}

}  // namespace tactics
