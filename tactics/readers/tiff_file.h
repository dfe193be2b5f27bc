// SPDX-License-Identifier: Apache-2.0
// An open TIFF: the tags of its first page, and its complaints.
#pragma once

#include <tiffio.h>

#include <array>
#include <cstdarg>
#include <cstdint>
#include <string>

#include "tactics/readers/read.h"
#include "tactics/readers/rows.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The tags of the first page.
struct TiffTags {
    std::uint32_t width = 0, height = 0, rows_per_strip = 0;
    std::uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT, photometric = 0, planar = PLANARCONFIG_CONTIG;
    std::uint16_t compression = COMPRESSION_NONE, orientation = 1, ink_set = INKSET_CMYK;
    bool tiled = false;
    bool preview = false;  ///< a reduced copy of a picture that is elsewhere in the file
    Alpha alpha = Alpha::none;
    int alpha_at = 0;  // which sample

    bool separate() const { return planar == PLANARCONFIG_SEPARATE && samples > 1; }
    bool palette() const { return photometric == PHOTOMETRIC_PALETTE; }
    bool ink() const { return photometric == PHOTOMETRIC_SEPARATED; }
    int colours() const { return photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE ? 1 : 3; }
    int stored_colours() const { return palette() ? 1 : ink() ? 4 : colours(); }
};

/// Throws Error(failed) for every complaint of libtiff, so that no unreadable data are shown.
class TiffFile {
public:
    explicit TiffFile(Source& source) : source_(source) {}
    ~TiffFile();
    TiffFile(const TiffFile&) = delete;
    TiffFile& operator=(const TiffFile&) = delete;

    void open();

    TIFF* get() const { return tiff_; }
    TiffTags& tags() { return tags_; }
    const TiffTags& tags() const { return tags_; }
    const std::string& name() const { return source_.name; }

    /// To be called after each reading call with what it answered, and the line (from 1) that was read.
    void require(bool good, long long line) const;

    /// `NAME: is a TIFF with what cannot be read; how to mend it`.
    [[noreturn]] void refuse(const Phrase& what) const;

private:
    [[noreturn]] void fail(long long line) const;
    void read_tags();

    static TiffFile& of(void* handle) { return *static_cast<TiffFile*>(handle); }
    static int on_error(TIFF*, void* user, const char*, const char* format, va_list words);
    static int on_warning(TIFF*, void* user, const char*, const char* format, va_list words);
    static tmsize_t on_read(thandle_t handle, void* to, tmsize_t count);
    static toff_t on_seek(thandle_t handle, toff_t offset, int from);

    Source& source_;
    TIFF* tiff_ = nullptr;
    TiffTags tags_;
    long size_ = 0;        // of the file
    bool broken_ = false;  // libtiff complained
    bool ended_ = false;   // something beyond the end of the file was requested
    std::array<char, 200> message_{};
};

}  // namespace tactics
