// SPDX-License-Identifier: Apache-2.0
// Any bytes as a report of a haptic mouse, unchanged and with a corrected checksum: a parsed report is the same after writing and
// reading.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "tactics/haptics/devices/mouse_report.h"

namespace {

using namespace tactics;

// As long division, bit by bit: CRC-16/CCITT-FALSE.
std::uint16_t check_of(std::span<const std::uint8_t> bytes) {
    std::uint32_t rest = 0xFFFF;
    for (const std::uint8_t byte : bytes)
        for (int bit = 7; bit >= 0; --bit) {
            const bool over = ((rest >> 15 ^ byte >> bit) & 1u) != 0;
            rest = (rest << 1 & 0xFFFF) ^ (over ? 0x1021u : 0u);
        }
    return static_cast<std::uint16_t>(rest);
}

void read_and_write(std::span<const std::uint8_t> bytes) {
    if (const auto force = force_report(bytes); force && !force_report(bytes_of(*force))) std::abort();
    const auto report = mouse_report(bytes);
    if (!report) return;
    const ReportBytes written = bytes_of(*report);
    if (check_of(std::span(written).first(62)) != written[62] + 256 * written[63]) std::abort();
    if (!std::equal(bytes.begin() + 3, bytes.begin() + 20, written.begin() + 3)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    read_and_write({data, size});
    ReportBytes right{};
    std::copy_n(data, std::min<std::size_t>(size, 62), right.begin());
    const std::uint16_t check = check_of(std::span(right).first(62));
    right[62] = static_cast<std::uint8_t>(check & 0xFF);
    right[63] = static_cast<std::uint8_t>(check >> 8);
    if (right[0] == 0x54 && right[1] == 1 && !mouse_report(right)) std::abort();
    read_and_write(right);
    return 0;
}
