// SPDX-License-Identifier: Apache-2.0
// TIFF by libtiff: the first page, in strips or tiles, a strip or a row of tiles at a time.
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/bits.h"
#include "tactics/readers/limits.h"
#include "tactics/readers/rows.h"
#include "tactics/readers/tiff_file.h"
#include "tactics/readers/tiff_rows.h"
#include "tactics/readers/upright.h"

namespace tactics {

namespace {

constexpr int kMaxSamples = 16;  // a pixel

RowShape shape_of(const TiffTags& tags) {
    RowShape shape;
    shape.size = {static_cast<int>(tags.width), static_cast<int>(tags.height)};
    shape.colours = tags.colours();
    shape.alpha = tags.alpha;
    shape.orientation = tags.orientation;
    return shape;
}

// 256 colours, of which the file has as many as its bits can count.
std::vector<std::uint8_t> palette_of(const TiffFile& file) {
    std::uint16_t* channels[3] = {};
    if (TIFFGetField(file.get(), TIFFTAG_COLORMAP, &channels[0], &channels[1], &channels[2]) == 0)
        file.refuse(phrase("whose palette is missing"));
    const std::size_t count = std::size_t{1} << file.tags().bits;
    // Some programs wrote 8-bit values into the 16-bit table.
    bool wide = false;
    for (const auto* channel : channels) wide = wide || std::any_of(channel, channel + count, [](auto v) { return v > 255; });
    std::vector<std::uint8_t> palette(3 * 256);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            palette[3 * i + c] = static_cast<std::uint8_t>(wide ? (channels[c][i] + 128u) / 257u : channels[c][i]);
    return palette;
}

// The samples that are shown, out of those that a pixel has.
std::vector<int> shown_samples(const TiffTags& tags) {
    std::vector<int> shown;
    for (int c = 0; c < tags.stored_colours(); ++c) shown.push_back(c);
    if (tags.alpha != Alpha::none) shown.push_back(tags.alpha_at);
    return shown;
}

// One row of samples, all of a pixel together; sample s of pixel x is planes[s][x * step].
template <class Sample>
void interleave(const std::vector<const Sample*>& planes, std::size_t step, std::size_t width, Sample* to) {
    const std::size_t channels = planes.size();
    for (std::size_t c = 0; c < channels; ++c)
        for (std::size_t x = 0; x < width; ++x) to[x * channels + c] = planes[c][x * step];
}

Image read_floats(TiffFile& file, const ReadRequest& request) {
    const TiffTags& tags = file.tags();
    if (tags.photometric != PHOTOMETRIC_MINISBLACK && tags.photometric != PHOTOMETRIC_RGB)
        file.refuse(phrase("of decimal numbers that are neither grey nor RGB"));
    const auto shown = shown_samples(tags);
    TiffRows raw(file);
    RowReceiver<float> rows(shape_of(tags), request);
    std::vector<float> row(shown.size() * tags.width);
    std::vector<const float*> planes(shown.size());
    for (std::uint32_t y = 0; y < tags.height; ++y) {
        raw.advance(y);
        for (std::size_t i = 0; i < shown.size(); ++i)
            planes[i] =
                reinterpret_cast<const float*>(raw.row(tags.separate() ? shown[i] : 0)) + (tags.separate() ? 0 : shown[i]);
        interleave(planes, tags.separate() ? 1 : tags.samples, tags.width, row.data());
        rows.add(row.data());
    }
    return rows.finish();
}

// Converts the stored colours to grey or RGB, followed by alpha.
void decode_colours(const TiffTags& tags, const std::vector<std::uint8_t>& palette, const std::vector<std::uint8_t>& stored,
                    std::vector<std::uint8_t>& shown) {
    const int extra = tags.alpha == Alpha::none ? 0 : 1;
    const std::uint8_t* from = stored.data();
    std::uint8_t* to = shown.data();
    for (std::uint32_t x = 0; x < tags.width; ++x) {
        if (tags.palette()) {
            for (std::size_t c = 0; c < 3; ++c) *to++ = palette[3 * std::size_t{*from} + c];
        } else if (tags.ink()) {
            for (int c = 0; c < 3; ++c) *to++ = static_cast<std::uint8_t>(((255u - from[c]) * (255u - from[3]) + 127u) / 255u);
        } else {
            *to++ = static_cast<std::uint8_t>(255 - *from);  // white is zero
        }
        from += tags.stored_colours();
        for (int i = 0; i < extra; ++i) *to++ = *from++;
    }
}

Image read_bytes(TiffFile& file, const ReadRequest& request) {
    const TiffTags& tags = file.tags();
    const auto shown = shown_samples(tags);
    const RowShape shape = shape_of(tags);
    const std::size_t width = tags.width, in_plane = width * (tags.separate() ? 1 : tags.samples);
    const bool plain = !tags.palette() && !tags.ink() && tags.photometric != PHOTOMETRIC_MINISWHITE;
    const bool in_order = !tags.separate() && shown.size() == tags.samples;
    const bool as_it_is = plain && in_order && tags.bits == 8;
    const auto palette = tags.palette() ? palette_of(file) : std::vector<std::uint8_t>();
    TiffRows raw(file);
    RowReceiver<std::uint8_t> rows(shape, request);
    std::vector<std::vector<std::uint8_t>> bytes(static_cast<std::size_t>(raw.planes()), std::vector<std::uint8_t>(in_plane));
    std::vector<std::uint8_t> stored(shown.size() * width), coded(static_cast<std::size_t>(shape.channels()) * width);
    std::vector<const std::uint8_t*> planes(shown.size());
    for (std::uint32_t y = 0; y < tags.height; ++y) {
        raw.advance(y);
        if (as_it_is) {
            rows.add(raw.row(0));
            continue;
        }
        for (std::size_t plane = 0; plane < bytes.size(); ++plane)
            (tags.palette() ? samples_to_indices : samples_to_bytes)(raw.row(static_cast<int>(plane)), tags.bits, in_plane,
                                                                     bytes[plane].data());
        if (!in_order) {
            for (std::size_t i = 0; i < shown.size(); ++i) {
                const auto sample = static_cast<std::size_t>(shown[i]);
                planes[i] = tags.separate() ? bytes[sample].data() : bytes[0].data() + sample;
            }
            interleave(planes, tags.separate() ? 1 : tags.samples, width, stored.data());
        }
        const std::vector<std::uint8_t>& samples = in_order ? bytes[0] : stored;
        if (!plain) decode_colours(tags, palette, samples, coded);
        rows.add(plain ? samples.data() : coded.data());
    }
    return rows.finish();
}

// Formats that only libtiff can convert to RGB (CIE Lab, subsampled YCbCr, LogLuv): read as one picture.
Image read_whole(TiffFile& file, const ReadRequest& request) {
    const TiffTags& tags = file.tags();
    check_whole_size(file.name(), "a TIFF in an unusual colour space", tags.width, tags.height);
    std::array<char, 1024> why{};
    if (TIFFRGBAImageOK(file.get(), why.data()) == 0) file.refuse(phrase("in a colour space that cannot be read"));
    const std::size_t width = tags.width;
    const auto raster = std::make_unique_for_overwrite<std::uint32_t[]>(width * tags.height);
    // Asking for the orientation that the file has leaves the rows alone.
    file.require(TIFFReadRGBAImageOriented(file.get(), tags.width, tags.height, raster.get(), tags.orientation, 1) == 1, 1);
    RowShape shape = shape_of(tags);
    shape.colours = 3;
    shape.alpha = Alpha::none;
    RowReceiver<std::uint8_t> rows(shape, request);
    std::vector<std::uint8_t> row(3 * width);
    for (std::size_t y = 0; y < tags.height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint32_t pixel = raster[y * width + x];
            row[3 * x] = static_cast<std::uint8_t>(TIFFGetR(pixel));
            row[3 * x + 1] = static_cast<std::uint8_t>(TIFFGetG(pixel));
            row[3 * x + 2] = static_cast<std::uint8_t>(TIFFGetB(pixel));
        }
        rows.add(row.data());
    }
    return rows.finish();
}

bool recognises_tiff(std::span<const unsigned char> head) {
    if (head.size() < 10) return false;
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    const std::string_view start = text.substr(0, 4);
    using namespace std::string_view_literals;
    if (start == "II*\0"sv && text.substr(8, 2) == "CR") return false;  // Canon's raw photos start with a thumbnail
    return start == "II*\0"sv || start == "MM\0*"sv || start == "II+\0"sv || start == "MM\0+"sv;
}

PictureInfo inspect_tiff(Source& source) {
    TiffFile file(source);
    file.open();
    const TiffTags& tags = file.tags();
    PictureInfo facts{"TIFF", static_cast<int>(tags.width), static_cast<int>(tags.height)};
    if (turns_sideways(tags.orientation)) std::swap(facts.width, facts.height);
    return facts;
}

Image read_tiff(Source& source, const ReadRequest& request) {
    TiffFile file(source);
    file.open();
    TiffTags& tags = file.tags();
    if (tags.preview) file.refuse(phrase("whose first page is only a preview (a camera's raw photo?)"));
    if (tags.compression == COMPRESSION_OJPEG) file.refuse(phrase("with the JPEG compression of 1992"));
    if (tags.samples < 1 || tags.samples > kMaxSamples) file.refuse(phrase("with {0} channels", std::to_string(tags.samples)));
    const bool jpeg = tags.compression == COMPRESSION_JPEG;
    if (tags.photometric == PHOTOMETRIC_YCBCR && jpeg && !tags.separate()) {
        TIFFSetField(file.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
        tags.photometric = PHOTOMETRIC_RGB;
    }
    const auto photometric = tags.photometric;
    if (photometric == PHOTOMETRIC_YCBCR || photometric == PHOTOMETRIC_CIELAB || photometric == PHOTOMETRIC_LOGL ||
        photometric == PHOTOMETRIC_LOGLUV)
        return read_whole(file, request);
    if (photometric > PHOTOMETRIC_PALETTE && !(tags.ink() && tags.ink_set == INKSET_CMYK))
        file.refuse(phrase("in a colour space that cannot be read"));
    if (tags.samples < tags.stored_colours()) file.refuse(phrase("with fewer channels than it has colours"));
    if (tags.format == SAMPLEFORMAT_IEEEFP && tags.bits == 32) return read_floats(file, request);
    const bool known = tags.bits == 1 || tags.bits == 2 || tags.bits == 4 || tags.bits == 8 || tags.bits == 16 || tags.bits == 32;
    if (!known || (tags.format != SAMPLEFORMAT_UINT && tags.format != SAMPLEFORMAT_VOID) || (tags.palette() && tags.bits > 8))
        file.refuse(phrase("with {0}-bit samples of an unusual kind", std::to_string(tags.bits)));
    return read_bytes(file, request);
}

}  // namespace

extern const Reader tiff_reader;
const Reader tiff_reader{
    .name = "TIFF",
    .summary =
        "scans; the first page, 1 to 32 bits and decimal numbers (as linear light), palette, CMYK, transparency over white",
    .extensions = "tif tiff",
    .recognises = recognises_tiff,
    .inspect = inspect_tiff,
    .read = read_tiff,
};

}  // namespace tactics
