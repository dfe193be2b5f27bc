// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/png_decoder.h"

#include <cstdio>
#include <memory>

#include "tactics/readers/limits.h"
#include "tactics/readers/upright.h"

namespace tactics {

namespace {

// Chunks that cost time or memory to unpack and say nothing about the pixels.
constexpr png_byte kUnreadChunks[] = "iCCP\0gAMA\0cHRM\0sRGB\0zTXt\0iTXt\0tEXt\0sPLT\0hIST\0pHYs\0tIME";

void on_warning(png_structp, png_const_charp) {}

}  // namespace

// libpng reports errors by a function that may not return; see jpeg.cpp for how exceptions and jumps are kept apart.
void PngDecoder::open() {
    std::rewind(source_.file.get());
    guarded([&] {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
        if (png_ == nullptr) std::longjmp(jump_, 1);
        info_ = png_create_info_struct(png_);
        if (info_ == nullptr) std::longjmp(jump_, 1);
        png_set_read_fn(png_, this, on_read);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // judged below, in our own words
        png_set_chunk_malloc_max(png_, 4 << 20);
        png_set_chunk_cache_max(png_, 100);
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, kUnreadChunks, static_cast<int>(sizeof kUnreadChunks / 5));
        png_read_info(png_, info_);
    });
    height_ = png_get_image_height(png_, info_);
    width_ = png_get_image_width(png_, info_);
    check_claimed_size(source_.name, width_, height_);
}

int PngDecoder::orientation() {
    png_uint_32 bytes = 0;
    png_bytep block = nullptr;
    return png_get_eXIf_1(png_, info_, &bytes, &block) != 0 ? exif_orientation({block, bytes}) : 1;
}

bool PngDecoder::is_deep_grey() const {
    return png_get_bit_depth(png_, info_) == 16 && png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY &&
           png_get_valid(png_, info_, PNG_INFO_tRNS) == 0;
}

void PngDecoder::check_interlaced() {
    interlaced_ = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
    if (interlaced_) check_whole_size(source_.name, "an interlaced PNG", width_, height_);
}

RowShape PngDecoder::start() {
    check_interlaced();
    guarded([&] {
        png_set_expand(png_);
        png_set_scale_16(png_);
        if (interlaced_) png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
    });
    RowShape shape;
    shape.size = size();
    const int channels = png_get_channels(png_, info_);
    shape.colours = channels >= 3 ? 3 : 1;
    shape.alpha = channels == 2 || channels == 4 ? Alpha::straight : Alpha::none;
    shape.orientation = orientation();
    return shape;
}

void PngDecoder::start_deep() {
    check_interlaced();
    guarded([&] {
        if (interlaced_) png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
    });
}

void PngDecoder::read(std::size_t row_bytes, const std::function<void(const std::uint8_t* row)>& take) {
    const std::size_t kept = interlaced_ ? height_ : 1;
    // Left as it comes from the system: what is not yet read is not yet there.
    const auto memory = std::make_unique_for_overwrite<std::uint8_t[]>(row_bytes * kept);
    const int passes = interlaced_ ? 7 : 1;
    for (int pass = 1; pass <= passes; ++pass)
        for (line_ = 0; line_ < height_; ++line_) {
            pass_ = interlaced_ ? pass : 0;
            std::uint8_t* row = memory.get() + (interlaced_ ? line_ * row_bytes : 0);
            guarded([&] { png_read_row(png_, row, nullptr); });
            if (pass == passes) take(row);
        }
}

void PngDecoder::on_error(png_structp png, png_const_charp message) {
    auto& decoder = *static_cast<PngDecoder*>(png_get_error_ptr(png));
    std::snprintf(decoder.message_.data(), decoder.message_.size(), "%s", message);
    std::longjmp(decoder.jump_, 1);
}

void PngDecoder::on_read(png_structp png, png_bytep to, std::size_t count) {
    auto& decoder = *static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (std::fread(to, 1, count, decoder.source_.file.get()) == count) return;
    decoder.ended_ = true;
    png_error(png, "the file ends");
}

void PngDecoder::fail() const {
    const long long line = height_ == 0 ? 0 : static_cast<long long>(line_) + 1;
    if (ended_) throw_cut_short(source_.name, line, height_, pass_);
    throw_damaged(source_.name, line, height_, message_.data(), pass_);
}

}  // namespace tactics
