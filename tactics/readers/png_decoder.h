// SPDX-License-Identifier: Apache-2.0
// A PNG file by libpng, row by row.
#pragma once

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstdint>
#include <functional>

#include "tactics/readers/read.h"
#include "tactics/readers/rows.h"

namespace tactics {

/// Throws Error(failed) for everything that libpng complains of.
class PngDecoder {
public:
    explicit PngDecoder(Source& source) : source_(source) {}
    ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;

    void open();
    Size size() const { return {static_cast<int>(width_), static_cast<int>(height_)}; }
    int orientation();
    /// Grey of 16 bits and nothing else.
    bool is_deep_grey() const;

    /// From here on rows are 8-bit grey or RGB, followed by alpha if the file has any kind of transparency.
    RowShape start();
    /// From here on rows are in stored form: for deep grey, 16 bits with the high byte first.
    void start_deep();
    /// All rows in their order.
    void read(std::size_t row_bytes, const std::function<void(const std::uint8_t* row)>& take);

private:
    template <class Body>
    void guarded(const Body& body) {
        if (setjmp(jump_) != 0) fail();
        body();
    }
    void check_interlaced();
    static void on_error(png_structp png, png_const_charp message);
    static void on_read(png_structp png, png_bytep to, std::size_t count);
    [[noreturn]] void fail() const;

    Source& source_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    png_uint_32 width_ = 0, height_ = 0, line_ = 0;
    int pass_ = 0;
    bool interlaced_ = false;
    bool ended_ = false;
    std::jmp_buf jump_{};
    std::array<char, 200> message_{"libpng has no memory"};
};

}  // namespace tactics
