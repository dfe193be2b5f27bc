// SPDX-License-Identifier: Apache-2.0
// The reports of a haptic mouse that anyone can build: 64 bytes to the computer and 64 from it, without ids, a thousand times a
// second (USB full speed, one interrupt endpoint each way, interval 1). Little-endian. The report descriptor begins with usage
// page FF54h, usage 01h, which identify the mouse; its vendor and product numbers do not matter. kMouseFields and kForceFields
// list the contents. Sensor x points to the right and y towards the hand, as on maps.
//
// CRC-16: polynomial 1021h, initial value FFFFh, no reflection (CRC-16/CCITT-FALSE). A mouse must ignore damaged reports; when
// the time of the last good one has passed, it takes its force to zero within 2 ms on its own and reports a fault. `tactics help
// mouse` describes all this.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tactics {

inline constexpr std::uint16_t kMouseUsagePage = 0xFF54;
inline constexpr std::uint8_t kMouseUsage = 0x01;

/// The report descriptor (HID 1.11, 6.2.2), one item per line: 64 bytes each way, without ids.
inline constexpr std::array<std::uint8_t, 27> kMouseDescriptor = {
    0x06,
    kMouseUsagePage & 0xFF,
    kMouseUsagePage >> 8,  // usage page: vendor-defined
    0x09,
    kMouseUsage,  // usage
    0xA1,
    0x01,  // application collection
    0x15,
    0x00,  // the least value
    0x26,
    0xFF,
    0x00,  // the most
    0x75,
    0x08,  // bits of one
    0x95,
    0x40,  // how many of them
    0x09,
    0x02,  // usage
    0x81,
    0x02,  // input: to the computer
    0x95,
    0x40,  // how many
    0x09,
    0x03,  // usage
    0x91,
    0x02,  // output: from the computer
    0xC0,  // end of the collection
};

struct ReportField {
    std::size_t first, last;  ///< bytes
    std::string_view what;
};
/// To the computer.
inline constexpr ReportField kMouseFields[] = {
    {0, 0, "54h"},
    {1, 1, "1, the version of this layout"},
    {2, 2, "bit 0 stop key, bit 1 motor on, bit 2 fault (hot, or no word)"},
    {3, 3, "number of the report, mod 256"},
    {4, 7, "clock of the mouse, us, mod 2^32"},
    {8, 11, "encoder, counts, signed, upwards; 0 is 0 mm of a map"},
    {12, 13, "first optical sensor, x, counts since the last report, signed"},
    {14, 15, "first optical sensor, y"},
    {16, 17, "second optical sensor, x"},
    {18, 19, "second optical sensor, y"},
    {20, 61, "0"},
    {62, 63, "CRC-16 of bytes 0 to 61"},
};
/// From the computer.
inline constexpr ReportField kForceFields[] = {
    {0, 0, "46h"},
    {1, 1, "1, the version of this layout"},
    {2, 2, "bit 0 motor on"},
    {3, 3, "number of the report, mod 256"},
    {4, 5, "force, mN, signed, upwards"},
    {6, 7, "how long it holds, ms"},
    {8, 61, "0"},
    {62, 63, "CRC-16 of bytes 0 to 61"},
};

/// ms for which a force of ours holds without another; then the mouse lets go on its own.
inline constexpr unsigned kForceHold = 3;

using ReportBytes = std::array<std::uint8_t, 64>;

struct MouseReport {
    bool stop_key = false, motor_on = false, fault = false;
    std::uint8_t number = 0;
    std::uint32_t microseconds = 0;
    std::int32_t encoder = 0;                                           ///< counts
    std::int16_t first_x = 0, first_y = 0, second_x = 0, second_y = 0;  ///< counts
};

struct ForceReport {
    bool motor_on = false;
    std::uint8_t number = 0;
    double force = 0;      ///< N, upwards; clamped to the field (32 N)
    unsigned hold_ms = 0;  ///< up to 65535
};

/// Nothing: the report is short, of another kind or version, or damaged.
std::optional<MouseReport> mouse_report(std::span<const std::uint8_t> bytes) noexcept;
std::optional<ForceReport> force_report(std::span<const std::uint8_t> bytes) noexcept;
ReportBytes bytes_of(const MouseReport& report) noexcept;
ReportBytes bytes_of(const ForceReport& report) noexcept;

}  // namespace tactics
