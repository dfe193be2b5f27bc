// SPDX-License-Identifier: Apache-2.0
// The symbols of a tile of slopes (slope_tile.h), the kinds of steepness, and the shares by which symbols are coded, as bytes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "tactics/coding/binary_coder.h"

namespace tactics::slope {

inline constexpr unsigned kPlain = 16;    ///< residuals below it are symbols
inline constexpr unsigned kSymbols = 40;  ///< 16, and two for each length from 5 to 16 bits
inline constexpr unsigned kKinds = 40;    ///< of steepness
inline constexpr unsigned kPartBits = 12, kParts = 1u << kPartBits;

/// Bits that follow a symbol, and the residual if they are zeros.
constexpr unsigned count_of(unsigned symbol) { return symbol < kPlain ? 0 : 3 + (symbol - kPlain) / 2; }
constexpr unsigned base_of(unsigned symbol) { return symbol < kPlain ? symbol : (2 + (symbol - kPlain) % 2) << count_of(symbol); }

/// Both ways are gone, as which is right is as good as chance in a photograph.
constexpr unsigned symbol_of(std::uint32_t residual) noexcept {
    const auto length = static_cast<unsigned>(std::bit_width(residual | kPlain)) - 1;  // 4 to 15
    const unsigned symbol = kPlain + 2 * (length - 4) + (residual >> (length - 1) & 1u);
    return residual < kPlain ? residual : symbol;
}

struct Rest {
    std::uint16_t base, count;
};
inline constexpr std::array<Rest, kSymbols> kRests = [] {
    std::array<Rest, kSymbols> rests{};
    for (unsigned s = 0; s < kSymbols; ++s)
        rests[s] = {static_cast<std::uint16_t>(base_of(s)), static_cast<std::uint16_t>(count_of(s))};
    return rests;
}();

/// Twice the logarithm of how much the levels around differ.
constexpr unsigned kind_of(unsigned steepness) noexcept {
    const unsigned twice = 2 * steepness + 1;  // so that 1 has a second bit, too
    const auto length = static_cast<unsigned>(std::bit_width(twice)) - 1;
    return length == 0 ? 0 : std::min(2 * length + (twice >> (length - 1) & 1u), kKinds - 1);
}

/// Shares of kParts by which the symbols of a kind are coded; those that occur have at least one.
using Shares = std::array<std::uint16_t, kSymbols>;

/// The tables of a tile: which kinds of steepness share one, and the shares of each.
struct Tables {
    std::array<std::uint8_t, kKinds> table_of{};  ///< by kind
    std::vector<Shares> shares;
};

/// Kinds next to each other share a table until it has enough levels. `counts`: of each kind.
Tables tables_of(const std::vector<std::array<std::uint32_t, kSymbols>>& counts);
void put_tables(const Tables& tables, BinaryEncoder& encoder);
/// False: they are none of put_tables.
bool get_tables(Tables& tables, BinaryDecoder& decoder);

}  // namespace tactics::slope
