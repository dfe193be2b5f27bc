// SPDX-License-Identifier: Apache-2.0
#include "print/png_file.h"

#include <zlib.h>

#include <cmath>
#include <utility>

namespace tactics {

namespace {

// Line drawings compress to a few hundredths at any level, and heights are no smaller at 6; higher ones only take longer
// (measured: A4 at 300 dpi; heights at 0.1 mm, where 6 takes a third longer).
constexpr int kPngLevel = 4;

void append_long(std::string& text, std::uint32_t value) {
    for (const unsigned shift : {24u, 16u, 8u, 0u}) text += static_cast<char>(static_cast<unsigned char>(value >> shift));
}

}  // namespace

PngFile::PngFile(std::uint32_t width, std::uint32_t height, int bits) : file_("\x89PNG\r\n\x1a\n"), data_(kPngLevel) {
    std::string header;
    append_long(header, width);
    append_long(header, height);
    header += static_cast<char>(bits);
    header += std::string{0, 0, 0, 0};  // grey, deflate, filter method 0, not interlaced
    append_chunk("IHDR", header);
}

void PngFile::scale(double per_metre_x, double per_metre_y) {
    std::string scale;
    append_long(scale, static_cast<std::uint32_t>(std::lround(per_metre_x)));
    append_long(scale, static_cast<std::uint32_t>(std::lround(per_metre_y)));
    append_chunk("pHYs", scale + '\1');
}

void PngFile::text(std::string_view key, std::string_view value) {
    append_chunk("tEXt", std::string(key) + '\0' + std::string(value));
}

void PngFile::add_row(std::span<const std::uint8_t> row) { data_.add(row); }

std::string PngFile::finish() {
    // Chunks may hold up to 2^31 - 1 bytes; pictures are bounded far below.
    append_chunk("IDAT", data_.finish());
    append_chunk("IEND", {});
    return std::move(file_);
}

void PngFile::append_chunk(std::string_view name, std::string_view data) {
    append_long(file_, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = file_.size();
    file_ += name;
    file_ += data;
    append_long(file_, static_cast<std::uint32_t>(
                           crc32_z(0, reinterpret_cast<const Bytef*>(file_.data() + start), file_.size() - start)));
}

}  // namespace tactics
