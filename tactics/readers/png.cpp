// SPDX-License-Identifier: Apache-2.0
// PNG by libpng, row by row. The gamma, colour profile and chromaticities in a file are not applied: samples are taken as
// sRGB, as most programs write and show them.
#include <algorithm>
#include <array>
#include <utility>

#include "tactics/readers/png_decoder.h"
#include "tactics/readers/upright.h"

namespace tactics {

namespace {

bool recognises_png(std::span<const unsigned char> head) {
    constexpr std::array<unsigned char, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    return head.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), head.begin());
}

PictureInfo inspect_png(Source& source) {
    PngDecoder decoder(source);
    decoder.open();
    PictureInfo facts{"PNG", decoder.size().width, decoder.size().height};
    if (turns_sideways(decoder.orientation())) std::swap(facts.width, facts.height);
    return facts;
}

Image read_png(Source& source, const ReadRequest& request) {
    PngDecoder decoder(source);
    decoder.open();
    const RowShape shape = decoder.start();
    RowReceiver<std::uint8_t> rows(shape, request);
    const std::size_t row_bytes = static_cast<std::size_t>(shape.size.width) * static_cast<std::size_t>(shape.channels());
    decoder.read(row_bytes, [&](const std::uint8_t* row) { rows.add(row); });
    return rows.finish();
}

}  // namespace

extern const Reader png_reader;
const Reader png_reader{
    .name = "PNG",
    .summary = "screenshots and drawings; 1 to 16 bits, palette, transparency over white (gamma and profiles are not applied)",
    .extensions = "png apng",
    .recognises = recognises_png,
    .inspect = inspect_png,
    .read = read_png,
};

}  // namespace tactics
