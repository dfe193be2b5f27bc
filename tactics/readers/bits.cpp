// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/bits.h"

#include <cstring>

namespace tactics {

namespace {

template <class Number>
Number number_at(const std::uint8_t* row, std::size_t index) {
    Number value;
    std::memcpy(&value, row + index * sizeof value, sizeof value);  // rows need not be aligned
    return value;
}

}  // namespace

void samples_to_indices(const std::uint8_t* row, int bits, std::size_t count, std::uint8_t* to) {
    if (bits == 8) {
        std::memcpy(to, row, count);
        return;
    }
    const unsigned mask = (1u << bits) - 1;
    for (std::size_t i = 0; i < count; ++row)
        for (int shift = 8 - bits; shift >= 0 && i < count; shift -= bits, ++i)  // from the left
            to[i] = static_cast<std::uint8_t>(*row >> shift & mask);
}

void samples_to_bytes(const std::uint8_t* row, int bits, std::size_t count, std::uint8_t* to) {
    if (bits == 16) {
        for (std::size_t i = 0; i < count; ++i)
            to[i] = static_cast<std::uint8_t>((number_at<std::uint16_t>(row, i) + 128u) / 257u);
        return;
    }
    if (bits == 32) {
        constexpr std::uint64_t kLargest = 0xFFFFFFFFu;
        for (std::size_t i = 0; i < count; ++i)
            to[i] = static_cast<std::uint8_t>((number_at<std::uint32_t>(row, i) * std::uint64_t{255} + kLargest / 2) / kLargest);
        return;
    }
    samples_to_indices(row, bits, count, to);
    const unsigned scale = 255u / ((1u << bits) - 1);  // 255, 85, 17, 1: always whole
    if (scale > 1)
        for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(to[i] * scale);
}

}  // namespace tactics
