// SPDX-License-Identifier: Apache-2.0
#include "print/one_bit_png.h"

namespace tactics {

OneBitPng::OneBitPng(int width, int height, double per_metre_x, double per_metre_y)
    : file_(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 1),
      row_(1 + (static_cast<std::size_t>(width) + 7) / 8) {
    if (per_metre_x > 0 && per_metre_y > 0) file_.scale(per_metre_x, per_metre_y);
}

void OneBitPng::add_row(const std::uint8_t* row) {
    // Filter 0 for every row, as the standard advises for less than 8 bits; in grey PNG a 1 is white.
    for (std::size_t i = 1; i < row_.size(); ++i) row_[i] = static_cast<std::uint8_t>(~row[i - 1]);
    file_.add_row(row_);
}

std::string OneBitPng::finish() { return file_.finish(); }

}  // namespace tactics
