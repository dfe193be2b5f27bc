// SPDX-License-Identifier: Apache-2.0
// Hostile JPEG files by the reader itself, whatever their first bytes are.
#include <cstdlib>

#include "tactics/error.h"
#include "tactics/readers/read.h"

namespace tactics {
extern const Reader jpeg_reader;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    if (size == 0) return 0;
    try {
        tactics::Source source = tactics::memory_source({data, size}, "fuzz");
        const auto info = tactics::jpeg_reader.inspect(source);
        if (static_cast<long long>(info.width) * info.height > 4'000'000) return 0;  // takes its time
        const auto image = tactics::jpeg_reader.read(source, {.longest = size % 3 == 0 ? 0 : 50, .colour = size % 2 == 0});
        if (image.pixels.size() != image.row_bytes() * static_cast<std::size_t>(image.height)) std::abort();
        if (size % 3 == 0 && (image.width != info.width || image.height != info.height)) std::abort();
    } catch (const tactics::Error&) {
    }
    return 0;
}
