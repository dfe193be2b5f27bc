// SPDX-License-Identifier: Apache-2.0
// PNG with one bit per pixel, row by row.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "print/png_file.h"

namespace tactics {

class OneBitPng {
public:
    /// Pixels per metre across and down; 0 = unspecified.
    OneBitPng(int width, int height, double per_metre_x, double per_metre_y);
    /// The next row, packed, most significant bit left, 1 = black.
    void add_row(const std::uint8_t* row);
    std::string finish();

private:
    PngFile file_;
    std::vector<std::uint8_t> row_;
};

}  // namespace tactics
