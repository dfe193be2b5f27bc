// SPDX-License-Identifier: Apache-2.0
// Samples of 1 to 32 bits, packed as TIFF packs them, as 8-bit samples.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tactics {

/// `count` unsigned samples of `bits` (1, 2, 4, 8, 16 or 32; the latter two in the machine's byte order) from a row,
/// scaled so that the largest value is 255 and rounded to nearest.
void samples_to_bytes(const std::uint8_t* row, int bits, std::size_t count, std::uint8_t* to);

/// The same without scaling, for palette indices; `bits` is at most 8.
void samples_to_indices(const std::uint8_t* row, int bits, std::size_t count, std::uint8_t* to);

}  // namespace tactics
