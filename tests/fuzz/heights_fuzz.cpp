// SPDX-License-Identifier: Apache-2.0
// Hostile height maps: what is read keeps its promises and comes back from what is written of it.
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "print/height_files.h"
#include "tactics/error.h"
#include "tactics/relief/read_heights.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    if (size == 0) return 0;
    try {
        tactics::Source source = tactics::memory_source({data, size}, "fuzz");
        if (const auto info = tactics::inspect_picture(source); static_cast<long long>(info.width) * info.height > 250'000)
            return 0;  // takes its time
        const auto file = tactics::read_heights(source, {});
        if (file.map.heights.size() != static_cast<std::size_t>(file.map.columns) * static_cast<std::size_t>(file.map.rows))
            std::abort();
        if (!(file.high > file.low) || !(file.map.pitch > 0)) std::abort();
        for (const float height : file.map.heights)
            if (!(height >= static_cast<float>(file.low) && height <= static_cast<float>(file.high))) std::abort();
        const std::string png = tactics::height_png(tactics::sheet_of(file.map, file.low, file.high), tactics::rows_of(file.map));
        tactics::Source again = tactics::memory_source({reinterpret_cast<const unsigned char*>(png.data()), png.size()}, "again");
        // Numbers in files have six decimals.
        const auto back = tactics::read_heights(again, {.low = file.low, .high = file.high});
        tactics::HeightSheet sheet = tactics::sheet_of(back.map, file.low, file.high);
        sheet.pitch = file.map.pitch;
        if (tactics::height_png(sheet, tactics::rows_of(back.map)) != png) std::abort();
    } catch (const tactics::Error&) {
    }
    return 0;
}
