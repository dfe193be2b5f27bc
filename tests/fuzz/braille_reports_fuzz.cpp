// SPDX-License-Identifier: Apache-2.0
// Any bytes as the report descriptor of a braille display: its lines stand within their reports, which are bounded, and its keys,
// too.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "tactics/transport/braille_reports.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const tactics::BrailleReports reports = tactics::braille_reports({data, size});
    for (const auto& line : reports.lines) {
        const auto report = reports.sizes.find(line.report);
        if (reports.columns <= 0 || report == reports.sizes.end() || report->second > 16'384) std::abort();
        if (line.begin + static_cast<std::size_t>(reports.columns) > report->second) std::abort();
    }
    for (const auto& entry : reports.keys)
        for (const auto& bits : entry.second)
            if (bits.begin >= bits.end || bits.end > 16'384 * 8) std::abort();
    tactics::KeyWatch keys(reports);
    keys.pressed({data, size});
    if (keys.pressed({data, size})) std::abort();  // what is down already
    return 0;
}
