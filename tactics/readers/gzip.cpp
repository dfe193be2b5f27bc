// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "tactics/error.h"

namespace tactics {

namespace {

constexpr int kGzipOnly = 16 + MAX_WBITS, kZlibOnly = MAX_WBITS;  // zlib.h, inflateInit2

struct Unpacked {
    std::string bytes;
    bool whole = false;  // to the checksum at the end
};

Unpacked unpack(std::string_view packed, std::size_t most, int format) {
    z_stream stream{};
    if (inflateInit2(&stream, format) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, inflateEnd);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(std::min<std::size_t>(packed.size(), UINT32_MAX));
    Unpacked unpacked;
    int state = Z_OK;
    while (state == Z_OK && unpacked.bytes.size() < most) {
        const std::size_t before = unpacked.bytes.size(),
                          step = std::min(most - before, std::clamp<std::size_t>(before, 1u << 14, 16u << 20));
        unpacked.bytes.resize(before + step);
        stream.next_out = reinterpret_cast<Bytef*>(unpacked.bytes.data() + before);
        stream.avail_out = static_cast<uInt>(step);
        state = inflate(&stream, Z_NO_FLUSH);
        unpacked.bytes.resize(before + step - stream.avail_out);
        // Nothing more comes out of a file that is cut.
        if (state == Z_OK && stream.avail_in == 0 && stream.avail_out > 0) break;
    }
    unpacked.whole = state == Z_STREAM_END;
    return unpacked;
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string gunzip(std::string_view bytes, std::size_t most, const std::string& name) {
    Unpacked unpacked = unpack(bytes, most, kGzipOnly);
    if (!unpacked.whole && unpacked.bytes.size() < most)
        throw Error(Fault::failed, name, phrase("is packed with gzip, and cut short or damaged; get a complete copy of it"));
    return std::move(unpacked.bytes);
}

std::string gunzip_beginning(std::string_view bytes, std::size_t most) { return unpack(bytes, most, kGzipOnly).bytes; }

std::string inflated(std::string_view bytes, std::size_t most, const std::string& name) {
    Unpacked unpacked = unpack(bytes, most, kZlibOnly);
    if (!unpacked.whole && unpacked.bytes.size() < most)
        throw Error(Fault::failed, name, phrase("what it carries of its drawing is damaged; get a complete copy of it"));
    return std::move(unpacked.bytes);
}

}  // namespace tactics
