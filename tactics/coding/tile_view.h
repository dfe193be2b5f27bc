// SPDX-License-Identifier: Apache-2.0
// A rectangle of levels of height within a larger map, and what is known of a level from those before it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace tactics {

using Level = std::uint16_t;

/// `Value` is Level or const Level.
template <typename Value>
struct TileView {
    Value* first = nullptr;  ///< upper left
    int columns = 0, rows = 0;
    std::size_t stride = 0;  ///< from one row to the next
    Value* row(int number) const { return first + static_cast<std::size_t>(number) * stride; }
    std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

/// Of the levels on the left, above and between them, the median edge detector's guess (M. Weinberger, G. Seroussi and G. Sapiro,
/// "The LOCO-I lossless image compression algorithm", IEEE Trans. Image Processing 9, 2000): a plane, but no further than its
/// neighbours.
inline int guess_of(int left, int above, int corner) noexcept {
    const int low = std::min(left, above), high = std::max(left, above);
    return std::clamp(left + above - corner, low, high);
}

}  // namespace tactics
