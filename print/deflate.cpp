// SPDX-License-Identifier: Apache-2.0
#include "print/deflate.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>

namespace tactics {

struct Deflater::Stream {
    z_stream z{};
};

Deflater::Deflater(int level) : stream_(std::make_unique<Stream>()) {
    if (deflateInit(&stream_->z, level) != Z_OK) throw std::bad_alloc();
}

Deflater::~Deflater() { deflateEnd(&stream_->z); }

void Deflater::pump(int flush) {
    std::array<Bytef, 16'384> buffer;
    z_stream& z = stream_->z;
    do {
        z.next_out = buffer.data();
        z.avail_out = static_cast<uInt>(buffer.size());
        deflate(&z, flush);
        out_.append(reinterpret_cast<const char*>(buffer.data()), buffer.size() - z.avail_out);
    } while (z.avail_out == 0);
}

void Deflater::add(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const auto part = bytes.first(std::min<std::size_t>(bytes.size(), std::numeric_limits<int>::max()));
        stream_->z.next_in = const_cast<Bytef*>(part.data());  // zlib does not write to it
        stream_->z.avail_in = static_cast<uInt>(part.size());
        pump(Z_NO_FLUSH);
        bytes = bytes.subspan(part.size());
    }
}

std::string Deflater::finish() {
    pump(Z_FINISH);
    return std::move(out_);
}

std::string deflated(std::string_view text, int level) {
    Deflater deflater(level);
    deflater.add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return deflater.finish();
}

}  // namespace tactics
