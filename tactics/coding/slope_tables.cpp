// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/slope_tables.h"

namespace tactics::slope {

namespace {

constexpr unsigned kShare = 512;  // levels that are worth a table

Shares shares_of(const std::array<std::uint32_t, kSymbols>& counts) {
    Shares shares{};
    std::uint64_t total = 0;
    for (const std::uint32_t count : counts) total += count;
    if (total == 0) return shares;
    unsigned given = 0, largest = 0;
    for (unsigned s = 0; s < kSymbols; ++s) {
        if (counts[s] == 0) continue;
        shares[s] = static_cast<std::uint16_t>(std::max<std::uint64_t>(1, counts[s] * std::uint64_t{kParts} / total));
        given += shares[s];
        if (shares[s] > shares[largest]) largest = s;
    }
    // What rounding left over, or took, is the most frequent symbol's; that is over kSymbols by far.
    shares[largest] = static_cast<std::uint16_t>(shares[largest] + kParts - given);
    return shares;
}

}  // namespace

void put_tables(const Tables& tables, BinaryEncoder& encoder) {
    Chance new_table;
    for (unsigned kind = 1; kind < kKinds; ++kind) encoder.put(new_table, tables.table_of[kind] != tables.table_of[kind - 1]);
    NumberChances share, behind_zero;
    for (const Shares& shares : tables.shares) {
        unsigned left = kParts;
        bool zero = false;
        for (unsigned s = 0; s < kSymbols && left > 0; ++s) {
            (zero ? behind_zero : share).put(encoder, shares[s]);
            zero = shares[s] == 0;
            left -= shares[s];
        }
    }
}

bool get_tables(Tables& tables, BinaryDecoder& decoder) {
    Chance new_table;
    std::uint8_t last = 0;
    for (unsigned kind = 1; kind < kKinds; ++kind) {
        last = static_cast<std::uint8_t>(last + (decoder.get(new_table) ? 1 : 0));
        tables.table_of[kind] = last;
    }
    tables.shares.assign(std::size_t{last} + 1, {});
    NumberChances share, behind_zero;
    for (Shares& shares : tables.shares) {
        unsigned left = kParts;
        bool zero = false;
        for (unsigned s = 0; s < kSymbols && left > 0; ++s) {
            const std::uint64_t told = (zero ? behind_zero : share).get(decoder);
            if (told > left) return false;
            shares[s] = static_cast<std::uint16_t>(told);
            zero = told == 0;
            left -= static_cast<unsigned>(told);
        }
        if (left > 0) return false;
    }
    return true;
}

Tables tables_of(const std::vector<std::array<std::uint32_t, kSymbols>>& counts) {
    Tables tables;
    std::array<std::uint32_t, kSymbols> sum{};
    std::uint64_t levels = 0;
    for (unsigned kind = 0; kind < kKinds; ++kind) {
        if (levels >= kShare) {
            tables.shares.push_back(shares_of(sum));
            sum = {};
            levels = 0;
        }
        tables.table_of[kind] = static_cast<std::uint8_t>(tables.shares.size());
        for (unsigned s = 0; s < kSymbols; ++s) {
            sum[s] += counts[kind][s];
            levels += counts[kind][s];
        }
    }
    if (levels == 0) {  // the last kinds are not there at all
        const auto last = static_cast<std::uint8_t>(tables.shares.empty() ? 0 : tables.shares.size() - 1);
        for (std::uint8_t& table : tables.table_of) table = std::min(table, last);
        if (tables.shares.empty()) tables.shares.push_back(shares_of({1}));
    } else {
        tables.shares.push_back(shares_of(sum));
    }
    return tables;
}

}  // namespace tactics::slope
