// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/devices/mouse_report.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

constexpr std::uint8_t kFromMouse = 0x54, kToMouse = 0x46, kVersion = 1;
constexpr std::size_t kSum = 62;

std::uint16_t crc_of(std::span<const std::uint8_t> bytes) noexcept {
    std::uint16_t crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
        crc = static_cast<std::uint16_t>(crc ^ byte << 8);
        for (int bit = 0; bit < 8; ++bit) crc = static_cast<std::uint16_t>((crc & 0x8000u) != 0 ? crc << 1 ^ 0x1021 : crc << 1);
    }
    return crc;
}

void put(ReportBytes& bytes, std::size_t at, std::size_t count, std::uint32_t value) noexcept {
    for (std::size_t i = 0; i < count; ++i) bytes[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
}

std::uint32_t get(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t count) noexcept {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value |= static_cast<std::uint32_t>(bytes[at + i]) << 8 * i;
    return value;
}

std::int16_t get_short(std::span<const std::uint8_t> bytes, std::size_t at) noexcept {
    return static_cast<std::int16_t>(get(bytes, at, 2));
}

bool is_whole(std::span<const std::uint8_t> bytes, std::uint8_t kind) noexcept {
    return bytes.size() >= 64 && bytes[0] == kind && bytes[1] == kVersion && get(bytes, kSum, 2) == crc_of(bytes.first(kSum));
}

void close_report(ReportBytes& bytes, std::uint8_t kind, std::uint8_t flags, std::uint8_t number) noexcept {
    bytes[0] = kind;
    bytes[1] = kVersion;
    bytes[2] = flags;
    bytes[3] = number;
    put(bytes, kSum, 2, crc_of(std::span(bytes).first(kSum)));
}

}  // namespace

std::optional<MouseReport> mouse_report(std::span<const std::uint8_t> bytes) noexcept {
    if (!is_whole(bytes, kFromMouse)) return std::nullopt;
    MouseReport report;
    report.stop_key = (bytes[2] & 1) != 0;
    report.motor_on = (bytes[2] & 2) != 0;
    report.fault = (bytes[2] & 4) != 0;
    report.number = bytes[3];
    report.microseconds = get(bytes, 4, 4);
    report.encoder = static_cast<std::int32_t>(get(bytes, 8, 4));
    report.first_x = get_short(bytes, 12);
    report.first_y = get_short(bytes, 14);
    report.second_x = get_short(bytes, 16);
    report.second_y = get_short(bytes, 18);
    return report;
}

std::optional<ForceReport> force_report(std::span<const std::uint8_t> bytes) noexcept {
    if (!is_whole(bytes, kToMouse)) return std::nullopt;
    return ForceReport{(bytes[2] & 1) != 0, bytes[3], get_short(bytes, 4) / 1000.0, get(bytes, 6, 2)};
}

ReportBytes bytes_of(const MouseReport& report) noexcept {
    ReportBytes bytes{};
    put(bytes, 4, 4, report.microseconds);
    put(bytes, 8, 4, static_cast<std::uint32_t>(report.encoder));
    put(bytes, 12, 2, static_cast<std::uint16_t>(report.first_x));
    put(bytes, 14, 2, static_cast<std::uint16_t>(report.first_y));
    put(bytes, 16, 2, static_cast<std::uint16_t>(report.second_x));
    put(bytes, 18, 2, static_cast<std::uint16_t>(report.second_y));
    close_report(bytes, kFromMouse,
                 static_cast<std::uint8_t>((report.stop_key ? 1 : 0) | (report.motor_on ? 2 : 0) | (report.fault ? 4 : 0)),
                 report.number);
    return bytes;
}

ReportBytes bytes_of(const ForceReport& report) noexcept {
    ReportBytes bytes{};
    const double millinewton = std::isfinite(report.force) ? std::clamp(std::round(report.force * 1000), -32767.0, 32767.0) : 0;
    put(bytes, 4, 2, static_cast<std::uint16_t>(static_cast<std::int16_t>(millinewton)));
    put(bytes, 6, 2, std::min(report.hold_ms, 65535u));
    close_report(bytes, kToMouse, report.motor_on ? 1 : 0, report.number);
    return bytes;
}

}  // namespace tactics
