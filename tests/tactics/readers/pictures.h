// SPDX-License-Identifier: Apache-2.0
// Pictures for the tests of the readers, and encoders to make files of them.
#pragma once

#include <gtest/gtest.h>
#include <png.h>
#include <tiffio.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

// clang-format off
#include <jpeglib.h>  // needs <cstdio> before it
// clang-format on

#include "tactics/error.h"
#include "tactics/readers/read.h"
#include "tactics/readers/shrink.h"

namespace tactics {

using Bytes = std::vector<unsigned char>;

/// Smooth shapes in every channel, different at each corner, so that no turn or flip goes unseen.
inline Image test_picture(int width, int height, int channels) {
    Image image = make_image(width, height, channels, 0, 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c) {
                const double u = (x + 0.5) / width, v = (y + 0.5) / height;
                const double wave = 40 * std::sin(9 * u + 2 * c) * std::cos(7 * v * v - c);
                image.row(y)[x * channels + c] = static_cast<std::uint8_t>(std::lround(60 + 90 * u + 40 * v + wave));
            }
    return image;
}

/// Every sample on its own: nothing is smooth.
inline Image noise_picture(int width, int height, int channels) {
    Image image = make_image(width, height, channels, 0, 0);
    std::uint32_t state = 12345;
    for (auto& sample : image.pixels) sample = static_cast<std::uint8_t>((state = state * 1664525u + 1013904223u) >> 24);
    return image;
}

/// The area average by its definition: each output pixel collects what it overlaps of each input pixel.
inline Image naive_shrink(const Image& image, int width, int height) {
    Image small = make_image(width, height, image.channels, 0, 0);
    const auto overlap = [](double a, double b, double c, double d) { return std::max(0.0, std::min(b, d) - std::max(a, c)); };
    const double across = double(image.width) / width, down = double(image.height) / height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < image.channels; ++c) {
                double sum = 0;
                for (int v = int(y * down); v < std::min(image.height, int((y + 1) * down) + 1); ++v)
                    for (int u = int(x * across); u < std::min(image.width, int((x + 1) * across) + 1); ++u)
                        sum += image.row(v)[u * image.channels + c] * overlap(u, u + 1, x * across, (x + 1) * across) *
                               overlap(v, v + 1, y * down, (y + 1) * down);
                small.row(y)[x * image.channels + c] = static_cast<std::uint8_t>(std::lround(sum / (across * down)));
            }
    return small;
}

inline int largest_difference(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.channels != b.channels) return 999;
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
    return largest;
}

inline double mean_of(const Image& image) {
    double sum = 0;
    for (const auto sample : image.pixels) sum += sample;
    return sum / static_cast<double>(image.pixels.size());
}

inline Image read_bytes(const Bytes& bytes, const ReadRequest& request = {.longest = 0, .colour = true}) {
    Source source = memory_source(bytes, "test");
    return read_picture(source, request);
}

/// The message with which reading fails, or "" when it does not.
inline std::string complaint(const Bytes& bytes, const ReadRequest& request = {}) {
    try {
        Source source = memory_source(bytes, "test");
        read_picture(source, request);
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::failed);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct JpegKind {
    int quality = 95;
    bool progressive = false;
    bool adobe = false;                  ///< four channels: inverted, with Adobe's marker; else as they are, without it
    J_COLOR_SPACE stored = JCS_UNKNOWN;  ///< what libjpeg chooses
    int restart_rows = 0;
    int orientation = 0;  ///< 0: no Exif block
};

/// A minimal Exif block: the header, one directory with one entry.
inline Bytes exif_block(int orientation, bool big_endian) {
    const auto value = static_cast<unsigned char>(orientation);
    Bytes block = {'E', 'x', 'i', 'f', 0, 0};
    const Bytes little = {'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0, 0x12, 1, 3, 0, 1, 0, 0, 0, value, 0, 0, 0, 0, 0, 0, 0};
    const Bytes big = {'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, value, 0, 0, 0, 0, 0, 0};
    const Bytes& rest = big_endian ? big : little;
    block.insert(block.end(), rest.begin(), rest.end());
    return block;
}

/// One, three or four (CMYK, 255 = full ink) channels.
inline Bytes jpeg_of(const Image& image, const JpegKind& kind = {}) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &memory, &size);
    info.image_width = static_cast<JDIMENSION>(image.width);
    info.image_height = static_cast<JDIMENSION>(image.height);
    info.input_components = image.channels;
    info.in_color_space = image.channels == 1 ? JCS_GRAYSCALE : image.channels == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&info);
    if (kind.stored != JCS_UNKNOWN) jpeg_set_colorspace(&info, kind.stored);
    if (image.channels == 4) info.write_Adobe_marker = kind.adobe ? TRUE : FALSE;
    jpeg_set_quality(&info, kind.quality, TRUE);
    for (int c = 0; c < info.num_components; ++c) info.comp_info[c].h_samp_factor = info.comp_info[c].v_samp_factor = 1;
    if (kind.progressive) jpeg_simple_progression(&info);
    info.restart_in_rows = kind.restart_rows;
    jpeg_start_compress(&info, TRUE);
    if (kind.orientation != 0) {
        const Bytes block = exif_block(kind.orientation, kind.orientation % 2 == 0);
        jpeg_write_marker(&info, JPEG_APP0 + 1, block.data(), static_cast<unsigned>(block.size()));
    }
    Bytes row(image.row_bytes());
    for (int y = 0; y < image.height; ++y) {
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = image.channels == 4 && kind.adobe ? static_cast<unsigned char>(255 - image.row(y)[i]) : image.row(y)[i];
        JSAMPROW pointer = row.data();
        jpeg_write_scanlines(&info, &pointer, 1);
    }
    jpeg_finish_compress(&info);
    jpeg_destroy_compress(&info);
    Bytes bytes(memory, memory + size);
    std::free(memory);
    return bytes;
}

/// `rows` as libpng wants them: packed, 16 bits big-endian. `more` may set palettes and the like.
inline Bytes png_of(int width, int height, int bits, int colour_type, const Bytes& rows, bool interlaced = false,
                    const std::function<void(png_structp, png_infop)>& more = {}) {
    Bytes bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp p, png_bytep data, png_size_t size) {
            auto& to = *static_cast<Bytes*>(png_get_io_ptr(p));
            to.insert(to.end(), data, data + size);
        },
        [](png_structp) {});
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits, colour_type,
                 interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (more) more(png, info);
    png_write_info(png, info);
    const std::size_t row_bytes = png_get_rowbytes(png, info);
    EXPECT_EQ(rows.size(), row_bytes * static_cast<std::size_t>(height));
    std::vector<png_bytep> pointers;
    for (int y = 0; y < height; ++y)
        pointers.push_back(const_cast<png_bytep>(rows.data()) + row_bytes * static_cast<std::size_t>(y));
    png_write_image(png, pointers.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

inline Bytes png_of(const Image& image, bool interlaced = false) {
    return png_of(image.width, image.height, 8, image.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, image.pixels,
                  interlaced);
}

struct TiffKind {
    int bits = 8;
    int samples = 1;
    int photometric = PHOTOMETRIC_MINISBLACK;
    int format = SAMPLEFORMAT_UINT;
    int compression = COMPRESSION_NONE;
    int rows_per_strip = 7;
    int tile = 0;  ///< side of tiles, 0: strips
    bool separate = false;
    int orientation = 0;
    int extra = -1;  ///< what the last sample is, EXTRASAMPLE_...
    bool big_endian = false;
    std::vector<std::array<std::uint16_t, 3>> palette = {};
};

/// `rows`: samples together, packed as TIFF packs them, in the machine's byte order; for separate planes and tiles only
/// whole bytes a sample.
inline Bytes tiff_of(int width, int height, const TiffKind& kind, const Bytes& rows) {
    std::FILE* file = std::tmpfile();
    TIFF* tiff = TIFFFdOpen(dup(fileno(file)), "test", kind.big_endian ? "wb" : "wl");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, kind.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, kind.samples);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, kind.format);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, kind.compression);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, kind.photometric);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, kind.separate ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
    if (kind.orientation != 0) TIFFSetField(tiff, TIFFTAG_ORIENTATION, kind.orientation);
    if (kind.compression == COMPRESSION_JPEG) {
        TIFFSetField(tiff, TIFFTAG_JPEGQUALITY, 95);
        TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    }
    const auto extra = static_cast<std::uint16_t>(kind.extra);
    if (kind.extra >= 0) TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &extra);
    std::array<std::vector<std::uint16_t>, 3> map;
    for (std::size_t c = 0; c < 3 && !kind.palette.empty(); ++c) {
        for (const auto& colour : kind.palette) map[c].push_back(colour[c]);
        map[c].resize(std::size_t{1} << kind.bits);
    }
    if (!kind.palette.empty()) TIFFSetField(tiff, TIFFTAG_COLORMAP, map[0].data(), map[1].data(), map[2].data());
    const std::size_t row_bytes = rows.size() / static_cast<std::size_t>(height);
    const std::size_t sample = static_cast<std::size_t>(kind.bits) / 8, pixel = sample * static_cast<std::size_t>(kind.samples);
    const int planes = kind.separate ? kind.samples : 1;
    const std::size_t unit = kind.separate ? sample : pixel;  // what is stored together
    if (kind.tile == 0) {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, kind.rows_per_strip);
        for (int plane = 0; plane < planes; ++plane)
            for (int top = 0; top < height; top += kind.rows_per_strip) {
                Bytes strip;
                for (int y = top; y < std::min(height, top + kind.rows_per_strip); ++y) {
                    const unsigned char* from = rows.data() + row_bytes * static_cast<std::size_t>(y);
                    if (!kind.separate) strip.insert(strip.end(), from, from + row_bytes);
                    for (std::size_t x = 0; kind.separate && x < static_cast<std::size_t>(width); ++x) {
                        const unsigned char* first = from + x * pixel + static_cast<std::size_t>(plane) * sample;
                        strip.insert(strip.end(), first, first + sample);
                    }
                }
                const auto number = TIFFComputeStrip(tiff, static_cast<std::uint32_t>(top), static_cast<std::uint16_t>(plane));
                EXPECT_GT(TIFFWriteEncodedStrip(tiff, number, strip.data(), static_cast<tmsize_t>(strip.size())), 0);
            }
    } else {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kind.tile);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, kind.tile);
        for (int plane = 0; plane < planes; ++plane)
            for (int top = 0; top < height; top += kind.tile)
                for (int left = 0; left < width; left += kind.tile) {
                    Bytes tile(static_cast<std::size_t>(kind.tile * kind.tile) * unit);
                    for (int y = top; y < std::min(height, top + kind.tile); ++y)
                        for (int x = left; x < std::min(width, left + kind.tile); ++x)
                            for (std::size_t i = 0; i < unit; ++i)
                                tile[static_cast<std::size_t>((y - top) * kind.tile + x - left) * unit + i] =
                                    rows[static_cast<std::size_t>(y) * row_bytes + static_cast<std::size_t>(x) * pixel +
                                         static_cast<std::size_t>(plane) * sample + i];
                    TIFFWriteTile(tiff, tile.data(), static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(top), 0,
                                  static_cast<std::uint16_t>(plane));
                }
    }
    TIFFClose(tiff);
    std::fseek(file, 0, SEEK_END);
    Bytes bytes(static_cast<std::size_t>(std::ftell(file)));
    std::rewind(file);
    EXPECT_EQ(std::fread(bytes.data(), 1, bytes.size(), file), bytes.size());
    std::fclose(file);
    return bytes;
}

inline Bytes tiff_of(const Image& image, TiffKind kind = {}) {
    kind.samples = image.channels;
    if (image.channels == 3 && kind.photometric == PHOTOMETRIC_MINISBLACK) kind.photometric = PHOTOMETRIC_RGB;
    return tiff_of(image.width, image.height, kind, image.pixels);
}

/// The picture as it is stored when the camera was held so that `orientation` makes it upright again: the twin of
/// turn_upright, pixel by pixel from the standard's words (where row 0 and column 0 are seen).
inline Image stored_as(const Image& upright, int orientation) {
    const bool sideways = orientation >= 5;
    Image stored =
        make_image(sideways ? upright.height : upright.width, sideways ? upright.width : upright.height, upright.channels, 0, 0);
    const int right = upright.width - 1, bottom = upright.height - 1;
    for (int row = 0; row < stored.height; ++row)
        for (int column = 0; column < stored.width; ++column) {
            int x = 0, y = 0;
            switch (orientation) {
                case 2: x = right - column, y = row; break;           // row 0 top, column 0 right
                case 3: x = right - column, y = bottom - row; break;  // bottom, right
                case 4: x = column, y = bottom - row; break;          // bottom, left
                case 5: x = row, y = column; break;                   // left, top
                case 6: x = right - row, y = column; break;           // right, top
                case 7: x = right - row, y = bottom - column; break;  // right, bottom
                case 8: x = row, y = bottom - column; break;          // left, bottom
                default: x = column, y = row; break;                  // top, left
            }
            for (int c = 0; c < upright.channels; ++c)
                stored.row(row)[column * upright.channels + c] = upright.row(y)[x * upright.channels + c];
        }
    return stored;
}

/// The same bytes read by OpenImageIO, in any format.
inline const Reader& openimageio() { return *readers().back(); }

}  // namespace tactics
