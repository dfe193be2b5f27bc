// SPDX-License-Identifier: Apache-2.0
// Hostile models.
#include <cmath>
#include <cstdlib>

#include "tactics/error.h"
#include "tactics/relief/read_heights.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    if (size == 0) return 0;
    try {
        tactics::Source source = tactics::memory_source({data, size}, "fuzz.stl");
        // A small map: what is slow is no fault here.
        const auto file = tactics::read_heights(source, {.pitch = 1, .width = 1 + static_cast<double>(size % 50)});
        if (file.map.heights.size() != static_cast<std::size_t>(file.map.columns) * static_cast<std::size_t>(file.map.rows))
            std::abort();
        for (const float height : file.map.heights)
            if (!(height >= static_cast<float>(file.low) && height <= static_cast<float>(file.high))) std::abort();
    } catch (const tactics::Error&) {
    }
    return 0;
}
