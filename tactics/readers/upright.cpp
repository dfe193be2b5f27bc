// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/upright.h"

#include <cstddef>
#include <cstdint>

namespace tactics {

namespace {

// Numbers in the byte order that the block says; 0 outside of it.
class Block {
public:
    explicit Block(std::span<const unsigned char> bytes) : bytes_(bytes), big_endian_(!bytes.empty() && bytes[0] == 'M') {}

    std::uint32_t number(std::size_t at, std::size_t size) const {
        if (at > bytes_.size() || bytes_.size() - at < size) return 0;
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < size; ++i) value = value << 8 | bytes_[at + (big_endian_ ? i : size - 1 - i)];
        return value;
    }

private:
    std::span<const unsigned char> bytes_;
    bool big_endian_;
};

}  // namespace

int exif_orientation(std::span<const unsigned char> bytes) {
    constexpr std::uint32_t kOrientation = 0x0112, kShort = 3;
    constexpr std::size_t kEntryBytes = 12;
    if (bytes.size() < 8 || bytes[0] != bytes[1] || (bytes[0] != 'I' && bytes[0] != 'M')) return 1;
    const Block block(bytes);
    if (block.number(2, 2) != 42) return 1;
    const std::size_t directory = block.number(4, 4);
    const std::size_t entries = block.number(directory, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + i * kEntryBytes;
        if (entry >= bytes.size()) break;
        if (block.number(entry, 2) != kOrientation || block.number(entry + 2, 2) != kShort) continue;
        const auto value = block.number(entry + 8, 2);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

Image turn_upright(Image image, int orientation) {
    if (orientation < 2 || orientation > 8) return image;
    const bool sideways = turns_sideways(orientation);
    // Bit by bit: which ends the source is read from, before the axes change places.
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Image turned = make_image(sideways ? image.height : image.width, sideways ? image.width : image.height, image.channels,
                              image.mm_per_pixel, 0);
    const std::ptrdiff_t step_x = image.channels, step_y = static_cast<std::ptrdiff_t>(image.row_bytes());
    const std::ptrdiff_t start = (from_right ? (image.width - 1) * step_x : 0) + (from_bottom ? (image.height - 1) * step_y : 0);
    const std::ptrdiff_t right = from_right ? -step_x : step_x, down = from_bottom ? -step_y : step_y;
    const std::ptrdiff_t along = sideways ? down : right, across = sideways ? right : down;
    std::uint8_t* to = turned.pixels.data();
    for (int y = 0; y < turned.height; ++y) {
        const std::uint8_t* from = image.pixels.data() + start + y * across;
        for (int x = 0; x < turned.width; ++x, to += image.channels, from += along)
            for (int c = 0; c < image.channels; ++c) to[c] = from[c];
    }
    return turned;
}

}  // namespace tactics
