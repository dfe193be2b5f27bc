// SPDX-License-Identifier: Apache-2.0
// Any bytes as a picture of any format: an Error or an Image of the size that was promised, nothing else.
#include <cstdlib>
#include <iterator>

#include "tactics/error.h"
#include "tactics/readers/read.h"

// Where a damaged AVIF has no compressed bytes, libheif 1.15 forgets 40 bytes that dav1d gave it (corpus/read/avif-empty).
extern "C" const char* __lsan_default_suppressions() { return "leak:libdav1d.so"; }

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    try {
        tactics::Source source = tactics::memory_source({data, size}, "fuzz");
        source.allowed = {std::begin(tactics::kAskedFormats), std::end(tactics::kAskedFormats)};
        const auto info = tactics::inspect_picture(source);
        // A large claim is legal and takes its time; whether it is refused is up to the tests.
        if (static_cast<long long>(info.width) * info.height > 4'000'000) return 0;
        const auto image = tactics::read_picture(source, {.longest = size % 3 == 0 ? 0 : 50, .colour = size % 2 == 0});
        if (image.width < 1 || image.height < 1 ||
            image.pixels.size() != image.row_bytes() * static_cast<std::size_t>(image.height))
            std::abort();
        if (size % 3 == 0 && (image.width != info.width || image.height != info.height)) std::abort();
    } catch (const tactics::Error&) {
    }
    return 0;
}
