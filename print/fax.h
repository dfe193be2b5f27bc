// SPDX-License-Identifier: Apache-2.0
// CCITT Group 4 (ITU-T T.6), the compression for line drawings that TIFF, PDF and PostScript level 2 share.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tactics/page.h"

namespace tactics {

/// A TIFF file in memory, 1 bit a pixel, written row by row.
class FaxTiff {
public:
    /// Strips of `rows_per_strip` rows; dots per inch 0 = not told.
    FaxTiff(int width, int height, int rows_per_strip, double dpi_x, double dpi_y);
    ~FaxTiff();
    FaxTiff(const FaxTiff&) = delete;
    FaxTiff& operator=(const FaxTiff&) = delete;

    /// Of `count` pages of one size the one of that number, from 0, comes next.
    void begin_page(int number, int count);
    void add_row(const std::uint8_t* row);  ///< packed, most significant bit left, 1 = black
    std::string finish();                   ///< the whole file
    std::string finish_strip();             ///< the first strip's data alone, for other formats

private:
    struct File;
    void describe();
    std::unique_ptr<File> file_;
    int width_, height_, rows_per_strip_;
    double dpi_x_, dpi_y_;
    std::uint32_t row_ = 0;
};

/// A picture's rows as one run of Group 4 data.
std::string group4_of(const Bitmap& bitmap);

}  // namespace tactics
