// SPDX-License-Identifier: Apache-2.0
// Reads whole 16-bit grey PNG, and the height entries of PNG files. libpng keeps text only before the pixels; picture editors
// move it after them.
#include <array>
#include <cstdio>

#include "tactics/error.h"
#include "tactics/readers/png_decoder.h"
#include "tactics/relief/found_heights.h"

namespace tactics {

namespace {

constexpr std::size_t kMostOurs = 200;  // bytes of one of our words
constexpr int kMostChunks = 1'000'000;

std::uint32_t number(const unsigned char* bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

}  // namespace

HeightWords png_height_words(Source& source) {
    HeightWords words;
    std::FILE* file = source.file.get();
    if (std::fseek(file, 8, SEEK_SET) != 0) return words;
    for (int i = 0; i < kMostChunks; ++i) {
        std::array<unsigned char, 8> head{};
        if (std::fread(head.data(), 1, head.size(), file) != head.size()) break;
        const std::uint32_t size = number(head.data());
        const std::string_view name(reinterpret_cast<const char*>(head.data()) + 4, 4);
        if (name == "IEND" || size > 0x7FFFFFFF) break;
        std::array<unsigned char, kMostOurs> data{};
        std::uint32_t got = 0;
        if ((name == "tEXt" || name == "pHYs") && size <= kMostOurs) {
            got = static_cast<std::uint32_t>(std::fread(data.data(), 1, size, file));
            if (got != size) break;
            const std::string_view text(reinterpret_cast<const char*>(data.data()), size);
            if (const auto end = text.find('\0'); name == "tEXt" && end != text.npos)
                words.take(text.substr(0, end), text.substr(end + 1));
            // We do not support non-square pixels: the resolution counts as missing.
            const bool metres = name == "pHYs" && size == 9 && data[8] == 1 && number(data.data()) == number(data.data() + 4);
            if (metres && number(data.data()) > 0) words.resolution_pitch = 1000.0 / number(data.data());
        }
        if (std::fseek(file, static_cast<long>(size - got) + 4, SEEK_CUR) != 0) break;
    }
    return words;
}

std::optional<FoundHeights> read_png_heights(Source& source) {
    PngDecoder decoder(source);
    decoder.open();
    if (!decoder.is_deep_grey() || decoder.orientation() != 1) return std::nullopt;
    const Size size = decoder.size();
    check_height_count(source.name, size.width, size.height);
    FoundHeights found{size.width, size.height, {}, false, {}, "16-bit PNG"};
    const auto width = static_cast<std::size_t>(size.width);
    found.values.reserve(width * static_cast<std::size_t>(size.height));
    decoder.start_deep();
    decoder.read(2 * width, [&](const std::uint8_t* row) {
        for (std::size_t x = 0; x < width; ++x)
            found.values.push_back(static_cast<float>(row[2 * x] << 8 | row[2 * x + 1]) / 65535);
    });
    found.words = png_height_words(source);
    return found;
}

}  // namespace tactics
