// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/adaptive_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

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

double log_of(std::uint32_t count) {
    static const auto kTable = [] {
        std::array<double, 1024> table{};
        for (std::size_t i = 1; i < table.size(); ++i) table[i] = std::log(static_cast<double>(i));
        return table;
    }();
    return count < kTable.size() ? kTable[count] : std::log(static_cast<double>(count));
}

// The logarithm of a count that is left to chance is too low on average. Grassberger's G (2003) takes its place, which is right
// on average: G(1) = -gamma - ln 2, each even count n adds 2 / (n - 1), an odd one has what the one before has. Near ln n.
double unbiased_log(std::uint32_t count) {
    static const auto kTable = [] {
        std::array<double, 1024> table{};
        double even = -std::numbers::egamma - std::numbers::ln2;
        for (std::size_t i = 1; i < table.size(); ++i) {
            if (i % 2 == 0) even += 2 / (static_cast<double>(i) - 1);
            table[i] = even;
        }
        return table;
    }();
    return count < kTable.size() ? kTable[count] : log_of(count);
}

// The digamma function (DLMF 5.11.2), which takes the place of ln n for the number of all that was counted, as unbiased_log does
// for the counts of each kind.
double digamma(double n) {
    constexpr double kLarge = 16;
    double less = 0;
    for (; n < kLarge; ++n) less += 1 / n;
    return std::log(n) - 1 / (2 * n) - 1 / (12 * n * n) - less;
}

}  // namespace

Code& Code::operator+=(const Code& other) {
    bits += other.bits;
    learnt += other.learnt;
    free += other.free;
    corrected += other.corrected;
    return *this;
}

Code adaptive_code(std::span<const std::uint32_t> counts, std::size_t levels) {
    double coded = 0, learnt = 0, corrected = 0, free = 0;  // nats, and a number
    for (std::size_t from = 0; from < counts.size(); from += levels) {
        std::uint64_t all = 0;
        for (const std::uint32_t count : counts.subspan(from, levels)) {
            if (count == 0) continue;
            all += count;
            ++free;
            coded -= log_of_count(count);
            learnt -= count * log_of(count);
            corrected -= count * unbiased_log(count);
        }
        if (all == 0) continue;
        const auto n = static_cast<double>(all);
        --free;
        coded += log_rising(static_cast<double>(levels) / 2, n);
        learnt += n * std::log(n);
        corrected += n * digamma(n);
    }
    return {std::max(0.0, coded / std::numbers::ln2), std::max(0.0, learnt / std::numbers::ln2), free,
            std::max(0.0, corrected / std::numbers::ln2)};
}

void add_up(std::vector<std::uint32_t>& counts, std::size_t fewer) {
    for (std::size_t from = fewer; from < counts.size(); from += fewer)
        for (std::size_t i = 0; i < fewer; ++i) counts[i] += counts[from + i];
    counts.resize(fewer);
}

std::vector<float> costs_of(std::span<const std::uint32_t> counts, std::size_t levels) {
    std::vector<float> costs(counts.size());
    for (std::size_t from = 0; from < counts.size(); from += levels) {
        const auto context = counts.subspan(from, levels);
        const auto all = static_cast<double>(std::accumulate(context.begin(), context.end(), std::uint64_t{0}));
        for (std::size_t i = 0; i < levels; ++i)
            if (context[i] > 0) costs[from + i] = static_cast<float>(std::log2(all / context[i]));
    }
    return costs;
}

}  // namespace tactics
