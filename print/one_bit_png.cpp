#include "print/one_bit_png.h"

#include <zlib.h>

#include <cmath>

namespace tactics {

namespace {

void append_long(std::string& text, std::uint32_t value) {
    for (const unsigned shift : {24u, 16u, 8u, 0u}) text += static_cast<char>(static_cast<unsigned char>(value >> shift));
}

void append_chunk(std::string& file, const char* name, const std::string& data) {
    append_long(file, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = file.size();
    file += name;
    file += data;
    append_long(file, static_cast<std::uint32_t>(
                          crc32_z(0, reinterpret_cast<const Bytef*>(file.data() + start), file.size() - start)));
}

// Line drawings compress to a few hundredths at any level; higher ones only take longer (measured: A4 at 300 dpi).
constexpr int kLevel = 4;

}  // namespace

OneBitPng::OneBitPng(int width, int height, double per_metre_x, double per_metre_y)
    : row_(1 + (static_cast<std::size_t>(width) + 7) / 8, '\0'), data_(kLevel) {
    file_ = "\x89PNG\r\n\x1a\n";
    std::string header;
    append_long(header, static_cast<std::uint32_t>(width));
    append_long(header, static_cast<std::uint32_t>(height));
    header += std::string{1, 0, 0, 0, 0};  // 1 bit, grey, deflate, filter method 0, not interlaced
    append_chunk(file_, "IHDR", header);
    if (per_metre_x > 0 && per_metre_y > 0) {
        std::string scale;
        append_long(scale, static_cast<std::uint32_t>(std::lround(per_metre_x)));
        append_long(scale, static_cast<std::uint32_t>(std::lround(per_metre_y)));
        append_chunk(file_, "pHYs", scale + '\1');
    }
}

void OneBitPng::add_row(const std::uint8_t* row) {
    // Filter 0 for every row, as the standard advises for less than 8 bits; in grey PNG a 1 is white.
    for (std::size_t i = 1; i < row_.size(); ++i) row_[i] = static_cast<char>(static_cast<unsigned char>(~row[i - 1]));
    data_.add({reinterpret_cast<const std::uint8_t*>(row_.data()), row_.size()});
}

std::string OneBitPng::finish() {
    // Chunks may hold up to 2^31 - 1 bytes; pictures are bounded far below.
    append_chunk(file_, "IDAT", data_.finish());
    append_chunk(file_, "IEND", {});
    return std::move(file_);
}

}  // namespace tactics
