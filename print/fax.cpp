// SPDX-License-Identifier: Apache-2.0
#include "print/fax.h"

#include <tiffio.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace tactics {

// A memory file for libtiff. Its operations cannot fail, and the callers' shapes satisfy libtiff's own rules.
struct FaxTiff::File {
    std::string bytes;
    std::size_t at = 0;
    TIFF* tiff = nullptr;

    static File& of(thandle_t self) { return *static_cast<File*>(self); }
    static tmsize_t read(thandle_t self, void* to, tmsize_t count) {
        File& file = of(self);
        const std::size_t left = file.bytes.size() - std::min(file.at, file.bytes.size());
        const std::size_t part = std::min(left, static_cast<std::size_t>(count));
        if (part > 0) std::memcpy(to, file.bytes.data() + file.at, part);
        file.at += part;
        return static_cast<tmsize_t>(part);
    }
    static tmsize_t write(thandle_t self, void* from, tmsize_t count) {
        File& file = of(self);
        const auto size = static_cast<std::size_t>(count);
        if (file.bytes.size() < file.at + size) file.bytes.resize(file.at + size);
        std::memcpy(file.bytes.data() + file.at, from, size);
        file.at += size;
        return count;
    }
    static toff_t seek(thandle_t self, toff_t offset, int whence) {
        File& file = of(self);
        const std::size_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? file.at : file.bytes.size();
        file.at = from + static_cast<std::size_t>(offset);
        return file.at;
    }
    static toff_t size(thandle_t self) { return of(self).bytes.size(); }
    static int close(thandle_t) { return 0; }
};

FaxTiff::FaxTiff(int width, int height, int rows_per_strip, double dpi_x, double dpi_y)
    : file_(std::make_unique<File>()),
      width_(width),
      height_(height),
      rows_per_strip_(rows_per_strip),
      dpi_x_(dpi_x),
      dpi_y_(dpi_y) {
    // "l": little-endian on every machine, for the same bytes.
    TIFF* tiff = TIFFClientOpen("memory", "wl", file_.get(), File::read, File::write, File::seek, File::close, File::size,
                                nullptr, nullptr);
    if (tiff == nullptr) throw std::logic_error("no TIFF in memory");
    file_->tiff = tiff;
    describe();
}

void FaxTiff::describe() {
    TIFF* tiff = file_->tiff;
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(width_));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(height_));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(rows_per_strip_));
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_CCITTFAX4);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE);
    TIFFSetField(tiff, TIFFTAG_FILLORDER, FILLORDER_MSB2LSB);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    if (dpi_x_ > 0 && dpi_y_ > 0) {
        TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
        TIFFSetField(tiff, TIFFTAG_XRESOLUTION, dpi_x_);
        TIFFSetField(tiff, TIFFTAG_YRESOLUTION, dpi_y_);
    }
}

FaxTiff::~FaxTiff() {
    if (file_->tiff != nullptr) TIFFClose(file_->tiff);
}

void FaxTiff::begin_page(int number, int count) {
    if (row_ > 0) {
        if (TIFFWriteDirectory(file_->tiff) != 1) throw std::logic_error("libtiff refused a page");
        describe();
        row_ = 0;
    }
    TIFFSetField(file_->tiff, TIFFTAG_SUBFILETYPE, FILETYPE_PAGE);
    TIFFSetField(file_->tiff, TIFFTAG_PAGENUMBER, number, count);
}

void FaxTiff::add_row(const std::uint8_t* row) {
    // libtiff asks for a pointer to what it might change, but a fax encoder only reads.
    if (TIFFWriteScanline(file_->tiff, const_cast<std::uint8_t*>(row), row_++, 0) != 1)
        throw std::logic_error("libtiff refused a row");
}

std::string FaxTiff::finish() {
    TIFFClose(file_->tiff);
    file_->tiff = nullptr;
    return std::move(file_->bytes);
}

std::string FaxTiff::finish_strip() {
    TIFFFlushData(file_->tiff);
    const std::uint64_t* offsets = nullptr;
    const std::uint64_t* counts = nullptr;
    TIFFGetField(file_->tiff, TIFFTAG_STRIPOFFSETS, &offsets);
    TIFFGetField(file_->tiff, TIFFTAG_STRIPBYTECOUNTS, &counts);
    if (offsets == nullptr || counts == nullptr) throw std::logic_error("libtiff wrote no strip");
    return file_->bytes.substr(static_cast<std::size_t>(offsets[0]), static_cast<std::size_t>(counts[0]));
}

std::string group4_of(const Bitmap& bitmap) {
    FaxTiff tiff(bitmap.width, bitmap.height, bitmap.height, 0, 0);
    for (int y = 0; y < bitmap.height; ++y) tiff.add_row(bitmap.bits.data() + bitmap.row_bytes() * static_cast<std::size_t>(y));
    return tiff.finish_strip();
}

}  // namespace tactics
