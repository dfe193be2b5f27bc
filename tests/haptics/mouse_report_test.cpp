// SPDX-License-Identifier: Apache-2.0
// Reports of the mouse, byte by byte as the header has them.
#include "tactics/haptics/devices/mouse_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tactics::mouse_report_test {
namespace {

TEST(MouseReport, ComesBackAsItWas) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 1000; ++trial) {
        MouseReport report;
        report.stop_key = random() % 2 == 0;
        report.motor_on = random() % 2 == 0;
        report.fault = random() % 2 == 0;
        report.number = static_cast<std::uint8_t>(random());
        report.microseconds = static_cast<std::uint32_t>(random());
        report.encoder = static_cast<std::int32_t>(random());
        report.first_x = static_cast<std::int16_t>(random());
        report.first_y = static_cast<std::int16_t>(random());
        report.second_x = static_cast<std::int16_t>(random());
        report.second_y = static_cast<std::int16_t>(random());
        const ReportBytes bytes = bytes_of(report);
        const auto back = mouse_report(bytes);
        ASSERT_TRUE(back);
        EXPECT_EQ(bytes_of(*back), bytes);
        // Any bit that is turned is seen.
        ReportBytes hurt = bytes;
        hurt[random() % 64] ^= static_cast<std::uint8_t>(1u << random() % 8);
        EXPECT_FALSE(mouse_report(hurt));
        EXPECT_FALSE(mouse_report(std::span(bytes).first(random() % 64)));
        EXPECT_FALSE(force_report(bytes));
    }
}

TEST(MouseReport, HasTheBytesOfTheTable) {
    MouseReport report;
    report.stop_key = true;
    report.number = 7;
    report.microseconds = 0x04030201;
    report.encoder = -2;
    report.second_y = 258;
    const ReportBytes bytes = bytes_of(report);
    EXPECT_EQ(bytes[0], 0x54);
    EXPECT_EQ(bytes[1], 1);
    EXPECT_EQ(bytes[2], 1);
    EXPECT_EQ(bytes[3], 7);
    EXPECT_EQ(bytes[4], 1);
    EXPECT_EQ(bytes[7], 4);
    EXPECT_EQ(bytes[8], 0xFE);
    EXPECT_EQ(bytes[11], 0xFF);
    EXPECT_EQ(bytes[18], 2);
    EXPECT_EQ(bytes[19], 1);
}

// Item by item, as HID 1.11, 6.2.2 has them, and as a kernel does.
TEST(MouseReport, DescriptorHasOneReportEachWayWithoutIds) {
    std::size_t bits = 0, count = 0, depth = 0, at = 0;
    std::vector<std::size_t> in, out;
    std::vector<unsigned> begin;
    while (at < kMouseDescriptor.size()) {
        const unsigned item = kMouseDescriptor[at++];
        const std::size_t size = (item & 3) == 3 ? 4 : item & 3;
        ASSERT_LE(at + size, kMouseDescriptor.size());
        unsigned value = 0;
        for (std::size_t i = 0; i < size; ++i) value |= static_cast<unsigned>(kMouseDescriptor[at++]) << 8 * i;
        if (begin.size() < 2) begin.push_back(value);
        if ((item & 0xFC) == 0x74) bits = value;
        if ((item & 0xFC) == 0x94) count = value;
        if ((item & 0xFC) == 0x80) in.push_back(bits * count);
        if ((item & 0xFC) == 0x90) out.push_back(bits * count);
        if ((item & 0xFC) == 0xA0) ++depth;
        if ((item & 0xFC) == 0xC0) --depth;
        EXPECT_NE(item & 0xFC, 0x84u) << "a report with an id";
    }
    EXPECT_EQ(begin, (std::vector<unsigned>{kMouseUsagePage, kMouseUsage}));
    EXPECT_EQ(in, std::vector<std::size_t>{8 * std::tuple_size_v<ReportBytes>});
    EXPECT_EQ(out, in);
    EXPECT_EQ(depth, 0u);
}

// The check value of CRC-16/CCITT-FALSE is 29B1h for "123456789"; here by a naive twin over a whole report.
TEST(MouseReport, SumIsCcitt) {
    const ReportBytes bytes = bytes_of(ForceReport{true, 9, 1.5, 5});
    unsigned crc = 0xFFFF;
    for (std::size_t i = 0; i < 62; ++i)
        for (int bit = 7; bit >= 0; --bit) {
            const bool top = ((crc >> 15) & 1u) != ((bytes[i] >> bit) & 1u);
            crc = (crc << 1) & 0xFFFF;
            if (top) crc ^= 0x1021;
        }
    EXPECT_EQ(bytes[62], crc & 0xFF);
    EXPECT_EQ(bytes[63], crc >> 8);
    EXPECT_EQ(bytes[4] | bytes[5] << 8, 1500);
    EXPECT_EQ(bytes[6], 5);
}

TEST(ForceReport, CutsWhatDoesNotFit) {
    EXPECT_DOUBLE_EQ(force_report(bytes_of(ForceReport{true, 1, -2.25, 5}))->force, -2.25);
    EXPECT_DOUBLE_EQ(force_report(bytes_of(ForceReport{true, 1, 1e9, 5}))->force, 32.767);
    EXPECT_DOUBLE_EQ(force_report(bytes_of(ForceReport{true, 1, -1e9, 5}))->force, -32.767);
    EXPECT_DOUBLE_EQ(force_report(bytes_of(ForceReport{true, 1, std::nan(""), 5}))->force, 0);
    EXPECT_EQ(force_report(bytes_of(ForceReport{true, 1, 0, 1'000'000}))->hold_ms, 65535u);
}

}  // namespace
}  // namespace tactics::mouse_report_test
