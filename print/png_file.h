// SPDX-License-Identifier: Apache-2.0
// A grey PNG file (ISO/IEC 15948), row by row.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "print/deflate.h"

namespace tactics {

/// Add everything that stands before the pixels before finish(); the chunks keep the order of the calls.
class PngFile {
public:
    PngFile(std::uint32_t width, std::uint32_t height, int bits);
    /// Pixels per metre across and down.
    void scale(double per_metre_x, double per_metre_y);
    void text(std::string_view key, std::string_view value);
    /// The next row in stored form: the number of its filter, then the filtered bytes.
    void add_row(std::span<const std::uint8_t> row);
    std::string finish();

private:
    void append_chunk(std::string_view name, std::string_view data);

    std::string file_;
    Deflater data_;
};

}  // namespace tactics
