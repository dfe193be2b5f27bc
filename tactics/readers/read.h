// SPDX-License-Identifier: Apache-2.0
// From a file of any kind to an Image, no larger than needed.
#pragma once

#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// Formats whose libraries break on hostile files: they are read only if the user trusts the file and names the format.
inline constexpr std::string_view kAskedFormats[] = {"psd", "ico"};

/// An open, seekable stream of bytes and the name to use in messages.
struct Source {
    std::string name;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{nullptr, &std::fclose};
    std::vector<std::string> allowed = {};  ///< of kAskedFormats
};

/// Opens a file for reading; "-" is standard input (spooled to an unnamed temporary file, at most kMaxInputBytes). Throws
/// Error(failed) for a missing, unreadable or empty file, or a directory.
Source open_source(const std::string& path);

/// Bytes in memory as a source; they must outlive it.
Source memory_source(std::span<const unsigned char> bytes, std::string name);

/// The facts known before any pixel is decoded.
struct PictureInfo {
    std::string format;  ///< "JPEG", "PNG", ...
    int width = 0;       ///< as shown, after the EXIF orientation
    int height = 0;
};

/// The request for the picture.
struct ReadRequest {
    /// The picture is shrunk by area averaging so that its longer side has at most this many pixels; 0 = as it is.
    /// It is never enlarged and keeps its shape to within half a pixel.
    int longest = 0;
    bool colour = false;  ///< 3 channels if the picture has colour; otherwise grey
};

/// Limits that keep hostile files from taking the machine.
inline constexpr long long kMaxInputBytes = 2LL * 1024 * 1024 * 1024;
inline constexpr int kMaxSide = 200'000;                     ///< pixels
inline constexpr long long kMaxPixels = 1'000'000'000LL;     ///< width * height
inline constexpr long long kMaxWholePixels = 120'000'000LL;  ///< where a format can only be decoded whole

/// The description of a reader. The readers are in readers/, one file for each format family.
struct Reader {
    std::string_view name;        ///< "JPEG"
    std::string_view summary;     ///< one line
    std::string_view extensions;  ///< "jpg jpeg", for messages and completion only: content decides
    bool (*recognises)(std::span<const unsigned char> head) = nullptr;  ///< the first bytes (up to 64)
    PictureInfo (*inspect)(Source& source) = nullptr;                   ///< from the start of the file
    Image (*read)(Source& source, const ReadRequest& request) = nullptr;
};

std::span<const Reader* const> readers();

/// Throw Error(failed) naming the file, what it looks like ("looks like a PDF document") and what could be read instead.
/// Both may be called in any order, more than once.
PictureInfo inspect_picture(Source& source);
Image read_picture(Source& source, const ReadRequest& request);

}  // namespace tactics
