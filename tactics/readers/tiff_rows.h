// SPDX-License-Identifier: Apache-2.0
// The rows of an open TIFF as they are stored.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>

#include "tactics/readers/tiff_file.h"

namespace tactics {

inline constexpr long long kMaxBandBytes = 4 * kMaxWholePixels;  // a strip or a row of tiles

/// The raw rows, whatever they are stored in: single rows, strips of one plane, or rows of tiles.
class TiffRows {
public:
    explicit TiffRows(TiffFile& file) : file_(file), tags_(file.tags()), planes_(tags_.separate() ? tags_.samples : 1) {
        const long long pixel_bits = (tags_.separate() ? 1LL : tags_.samples) * tags_.bits;
        row_bytes_ = (tags_.width * pixel_bits + 7) / 8;
        std::uint32_t band = 1;
        if (tags_.tiled) {
            std::uint32_t tile_width = 0;
            TIFFGetField(file_.get(), TIFFTAG_TILEWIDTH, &tile_width);
            TIFFGetField(file_.get(), TIFFTAG_TILELENGTH, &band);
            tile_bytes_ = TIFFTileSize(file_.get());
            tile_row_bytes_ = TIFFTileRowSize(file_.get());
            tile_width_ = tile_width;
            if (tile_width == 0 || band == 0 || tile_bytes_ <= 0 || tile_row_bytes_ <= 0 || tile_bytes_ > kMaxBandBytes)
                file_.refuse(phrase("with tiles of an impossible size"));
            // Tiles are put side by side byte by byte (TIFF 6.0 wants widths that are multiples of 16, so they can be).
            const long long tile_row_bits = tile_width * pixel_bits;
            if (tile_row_bits % 8 != 0 || tile_row_bytes_ != tile_row_bits / 8 || tile_bytes_ != band * tile_row_bytes_)
                file_.refuse(phrase("with tiles of an unusual size"));
            tile_ = std::make_unique_for_overwrite<std::uint8_t[]>(static_cast<std::size_t>(tile_bytes_));
        } else if (tags_.separate()) {
            band = std::min(tags_.rows_per_strip, tags_.height);
        }
        // Rows of subsampled colours would be larger than their pixels; those are read in another way.
        if (!tags_.tiled && TIFFScanlineSize(file_.get()) > row_bytes_) file_.refuse(phrase("whose rows are of an unusual size"));
        band_rows_ = std::max(1u, std::min(band, tags_.height));
        if (static_cast<long long>(band_rows_) * row_bytes_ * planes_ > kMaxBandBytes)
            file_.refuse(phrase("whose strips or tiles are too large to be read"));
        band_.reset(new std::uint8_t[static_cast<std::size_t>(band_rows_ * row_bytes_ * planes_)]);
    }

    int planes() const { return planes_; }

    /// To be called with y = 0, 1, 2, ...
    void advance(std::uint32_t y) {
        y_ = y;
        if (y % band_rows_ != 0) return;
        for (int plane = 0; plane < planes_; ++plane) {
            if (tags_.tiled)
                read_tiles(y, plane);
            else if (tags_.separate())
                read_strip(y, plane);
            else
                file_.require(TIFFReadScanline(file_.get(), band_.get(), y, 0) == 1, y + 1LL);
        }
    }

    const std::uint8_t* row(int plane) const { return at(plane, y_ % band_rows_); }

private:
    std::uint8_t* at(int plane, long long row) const {
        return band_.get() + (static_cast<long long>(plane) * band_rows_ + row) * row_bytes_;
    }

    void read_strip(std::uint32_t y, int plane) {
        const auto rows = std::min(band_rows_, tags_.height - y);
        const auto strip = TIFFComputeStrip(file_.get(), y, static_cast<std::uint16_t>(plane));
        const auto bytes = static_cast<tmsize_t>(rows * row_bytes_);
        file_.require(TIFFReadEncodedStrip(file_.get(), strip, at(plane, 0), bytes) == bytes, y + 1LL);
    }

    void read_tiles(std::uint32_t y, int plane) {
        const auto rows = std::min(band_rows_, tags_.height - y);
        long long left = 0;
        for (std::uint32_t x = 0; x < tags_.width; x += tile_width_, left += tile_row_bytes_) {
            const auto tile = TIFFComputeTile(file_.get(), x, y, 0, static_cast<std::uint16_t>(plane));
            file_.require(TIFFReadEncodedTile(file_.get(), tile, tile_.get(), tile_bytes_) == tile_bytes_, y + 1LL);
            const auto bytes = static_cast<std::size_t>(std::min<long long>(tile_row_bytes_, row_bytes_ - left));
            for (std::uint32_t row = 0; row < rows; ++row)
                std::memcpy(at(plane, row) + left, tile_.get() + row * tile_row_bytes_, bytes);
        }
    }

    TiffFile& file_;
    const TiffTags& tags_;
    int planes_;
    long long row_bytes_ = 0;
    std::uint32_t band_rows_ = 1, tile_width_ = 0, y_ = 0;
    tmsize_t tile_bytes_ = 0, tile_row_bytes_ = 0;
    std::unique_ptr<std::uint8_t[]> tile_, band_;
};

}  // namespace tactics
