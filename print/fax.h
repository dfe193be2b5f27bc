// SPDX-License-Identifier: Apache-2.0
// CCITT Group 4 (ITU-T T.6), the line-drawing compression shared by TIFF, PDF and PostScript level 2.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tactics/page.h"

namespace tactics {

/// A TIFF file in memory, 1 bit per pixel, written row by row.
class FaxTiff {
public:
    /// Strips of `rows_per_strip` rows; dots per inch 0 = unspecified.
    FaxTiff(int width, int height, int rows_per_strip, double dpi_x, double dpi_y);
    ~FaxTiff();
    FaxTiff(const FaxTiff&) = delete;
    FaxTiff& operator=(const FaxTiff&) = delete;

    /// Begins page number `page`, from 0, of `count` pages of the same size.
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

/// A picture's rows as one block of Group 4 data.
std::string group4_of(const Bitmap& bitmap);

}  // namespace tactics
