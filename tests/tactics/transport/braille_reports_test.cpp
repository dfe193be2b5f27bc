// SPDX-License-Identifier: Apache-2.0
// Report descriptors of braille displays, built by hand from HID 1.11, 6.2.2, and page 41h of the usage tables.
#include "tactics/transport/braille_reports.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <random>
#include <tuple>

#include "tactics/error.h"
#include "tactics/haptics/devices/mouse_report.h"
#include "tactics/transport/devices.h"
#include "tactics/transport/hid_displays.h"
#include "tactics/transport/hid_reports.h"
#include "tests/cli/tool.h"

namespace tactics::braille_reports_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes joined(const std::vector<Bytes>& parts) {
    Bytes all;
    for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

const Bytes kPage{0x05, 0x41}, kDisplay{0x09, 0x01, 0xA1, 0x01}, kRow{0x09, 0x02, 0xA1, 0x02}, kEnd{0xC0},
    kBytes{0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08};
Bytes report(std::uint8_t id) { return {0x85, id}; }
Bytes cells(std::uint8_t count, std::uint8_t usage = 0x03) { return {0x95, count, 0x09, usage, 0x91, 0x02}; }
Bytes keys(std::uint8_t count) { return {0x95, count, 0x09, 0xFA, 0x81, 0x02}; }

TEST(BrailleReports, OneRowAsDisplaysHaveIt) {
    const BrailleReports reports =
        braille_reports(joined({kPage, kDisplay, kBytes, report(2), keys(4), report(1), kRow, cells(40), kEnd, kEnd}));
    ASSERT_EQ(reports.lines.size(), 1u);
    EXPECT_EQ(reports.columns, 40);
    EXPECT_EQ(reports.dots, 8);
    EXPECT_EQ(reports.lines[0].report, 1);
    EXPECT_EQ(reports.lines[0].begin, 0u);
    EXPECT_EQ(reports.sizes, (std::map<int, std::size_t>{{1, 40}}));
    EXPECT_TRUE(reports.numbered);
}

TEST(BrailleReports, RowsInOneReportOrInSeveral) {
    const BrailleReports one = braille_reports(
        joined({kPage, kDisplay, kBytes, kRow, cells(20), kEnd, kRow, cells(20), kEnd, kRow, cells(20), kEnd, kEnd}));
    ASSERT_EQ(one.lines.size(), 3u);
    EXPECT_EQ(one.lines[2].begin, 40u);
    EXPECT_EQ(one.sizes, (std::map<int, std::size_t>{{0, 60}}));
    EXPECT_FALSE(one.numbered);
    const BrailleReports several = braille_reports(
        joined({kPage, kDisplay, kBytes, kRow, report(7), cells(32, 4), kEnd, kRow, report(9), cells(32, 4), kEnd, kEnd}));
    ASSERT_EQ(several.lines.size(), 2u);
    EXPECT_EQ(several.dots, 6);
    EXPECT_EQ(several.lines[0].report, 7);
    EXPECT_EQ(several.lines[1].report, 9);
    EXPECT_EQ(several.lines[1].begin, 0u);
    EXPECT_EQ(several.sizes, (std::map<int, std::size_t>{{7, 32}, {9, 32}}));
}

TEST(BrailleReports, WhatElseIsInAReportIsSteppedOver) {
    const Bytes padding{0x95, 0x03, 0x91, 0x01}, other{0x95, 0x02, 0x0A, 0x00, 0x02, 0x91, 0x02};
    const BrailleReports reports = braille_reports(joined({kPage, kDisplay, kBytes, report(3), padding, other, cells(2), kRow,
                                                           cells(20), kEnd, kRow, cells(20), kEnd, other, kEnd}));
    ASSERT_EQ(reports.lines.size(), 2u);  // the two cells are its status
    EXPECT_EQ(reports.columns, 20);
    EXPECT_EQ(reports.lines[0].begin, 7u);
    EXPECT_EQ(reports.lines[1].begin, 27u);
    EXPECT_EQ(reports.sizes, (std::map<int, std::size_t>{{3, 49}}));
}

TEST(BrailleReports, ARowIsItsCollectionHoweverManyItemsItHas) {
    const Bytes cell = cells(1);
    Bytes twenty;
    for (int i = 0; i < 20; ++i) twenty.insert(twenty.end(), cell.begin(), cell.end());
    const Bytes row = joined({kRow, cells(20), cells(20), kEnd});
    for (const auto& [bytes, columns, lines] : {std::tuple{joined({kRow, cells(20), cells(20), kEnd}), 40, 1u},
                                                {joined({kRow, twenty, kEnd}), 20, 1u},
                                                {twenty, 20, 1u},
                                                {joined({cells(20), cells(20)}), 40, 1u},
                                                {joined({row, row}), 40, 2u},
                                                {joined({report(1), row, report(2), row}), 40, 2u},
                                                // What follows on what stands elsewhere is another line.
                                                {joined({kRow, report(1), cells(20), report(2), cells(20), kEnd}), 20, 2u},
                                                {joined({kRow, cells(20), {0x95, 1, 0x91, 0x01}, cells(20), kEnd}), 20, 2u}}) {
        const BrailleReports reports = braille_reports(joined({kPage, kDisplay, kBytes, bytes, kEnd}));
        EXPECT_EQ(reports.columns, columns);
        EXPECT_EQ(reports.lines.size(), lines);
    }
}

// HID 1.11, 6.2.2.8: the last usage page before the main item counts, wherever the usage stands.
TEST(BrailleReports, AUsagePageBehindTheUsageCounts) {
    const Bytes behind{0x05, 0x01, 0x95, 20, 0x09, 0x03, 0x05, 0x41, 0x91, 0x02},
        elsewhere{0x05, 0x41, 0x95, 20, 0x09, 0x03, 0x05, 0x01, 0x91, 0x02};
    EXPECT_EQ(braille_reports(joined({kPage, kDisplay, kBytes, behind, kEnd})).columns, 20);
    EXPECT_TRUE(braille_reports(joined({kPage, kDisplay, kBytes, elsewhere, kEnd})).lines.empty());
    const Bytes display_behind{0x05, 0x01, 0x09, 0x01, 0x05, 0x41, 0xA1, 0x01};
    EXPECT_EQ(braille_reports(joined({display_behind, kBytes, cells(20), kEnd})).columns, 20);
}

using Spans = std::map<int, std::vector<std::pair<std::size_t, std::size_t>>>;
Spans keys_of(const BrailleReports& reports) {
    Spans all;
    for (const auto& entry : reports.keys)
        for (const BrailleReports::Bits& bits : entry.second) all[entry.first].emplace_back(bits.begin, bits.end);
    return all;
}

// Report 2: a byte of battery, 3 fixed bits, 5 keys of braille, 2 buttons and 6 lights that are none; report 3: a joystick's
// numbers; report 4: 40 routing keys that have one usage.
const Bytes kBits{0x75, 0x01}, kBattery{0x75, 0x08, 0x95, 1, 0x05, 0x06, 0x09, 0x20, 0x81, 0x02}, kFixed{0x95, 3, 0x81, 0x01},
    kFive{0x05, 0x41, 0x95, 5, 0x1A, 0x01, 0x02, 0x2A, 0x05, 0x02, 0x81, 0x02},
    kMixed{0x95, 8, 0x05, 0x08, 0x0B, 1, 0, 9, 0, 0x0B, 2, 0, 9, 0, 0x09, 0x4B, 0x81, 0x02},
    kNumbers{0x75, 0x08, 0x95, 2, 0x05, 0x41, 0x09, 0xFA, 0x81, 0x02}, kRouting{0x75, 0x01, 0x95, 40, 0x09, 0xFA, 0x81, 0x02},
    kArray{0x95, 8, 0x09, 0xFA, 0x81, 0x00},
    kMouse{0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x05, 0x09, 0x95, 3, 0x09, 1, 0x81, 0x02, 0xC0};

Bytes with_keys() {
    return joined({kPage, kDisplay, kBytes, report(1), cells(20), report(2), kBattery, kBits, kFixed, kFive, kMixed, report(3),
                   kNumbers, report(4), kRouting, kArray, kEnd, report(5), kMouse});
}

TEST(BrailleReports, KeysAreBitsOfTheirOwn) {
    EXPECT_EQ(keys_of(braille_reports(with_keys())), (Spans{{2, {{11, 16}, {16, 17}, {17, 18}}}, {4, {{0, 40}}}}));
    EXPECT_TRUE(braille_reports(joined({kPage, kDisplay, kBytes, cells(20), keys(4), kEnd})).keys.empty());
}

TEST(BrailleReports, AKeyIsPressedWhenNoneWasDown) {
    KeyWatch watch(braille_reports(with_keys()));
    const auto pressed = [&](const Bytes& bytes) { return watch.pressed(bytes); };
    for (const Bytes& other : {Bytes{2, 99, 0x07, 0xFC}, {3, 1, 1}, {5, 1}, {1, 255}, {4, 0, 0, 0, 0, 0, 0xFF}, {2}, {}})
        EXPECT_FALSE(pressed(other));
    EXPECT_TRUE(pressed({2, 99, 0x08, 0}));
    EXPECT_FALSE(pressed({2, 99, 0x18, 0})) << "a second one beside it";
    EXPECT_FALSE(pressed({4, 0, 1, 0, 0, 0})) << "one of another report";
    EXPECT_FALSE(pressed({2, 98, 0x07, 0}));
    EXPECT_FALSE(pressed({4, 0, 0, 1, 0, 0})) << "never none was down";
    EXPECT_FALSE(pressed({4, 0, 0, 0, 0, 0}));
    EXPECT_TRUE(pressed({4, 0, 0, 0, 0, 0x80}));
    EXPECT_FALSE(pressed({4}));
    EXPECT_TRUE(pressed({2, 0, 0, 2}));
    KeyWatch bare(braille_reports(joined({kPage, kDisplay, kBytes, cells(20), kRouting, kEnd})));
    EXPECT_TRUE(bare.pressed(Bytes{0, 1}));
    EXPECT_FALSE(bare.pressed(Bytes{0, 2}));
}

TEST(BrailleReports, TheStateOfItemsIsTheStandards) {
    // The page of a usage of four bytes is its own; pushed and popped; a long item; a usage ends with its main item.
    const Bytes pushed{0xA4, 0x05, 0x01, 0x75, 0x01, 0xB4}, long_item{0xFE, 0x03, 0xF0, 1, 2, 3},
        wide{0x95, 20, 0x0B, 0x03, 0x00, 0x41, 0x00, 0x91, 0x02}, silent{0x95, 5, 0x91, 0x02};
    const BrailleReports reports =
        braille_reports(joined({kPage, kDisplay, kBytes, pushed, long_item, {0x05, 0x01}, wide, silent, kEnd}));
    ASSERT_EQ(reports.lines.size(), 1u);
    EXPECT_EQ(reports.columns, 20);
    EXPECT_EQ(reports.sizes, (std::map<int, std::size_t>{{0, 25}}));
}

TEST(BrailleReports, OthersAreNoDisplays) {
    const Bytes bits{0x75, 0x01}, fixed{0x95, 20, 0x09, 0x03, 0x91, 0x01};
    for (const Bytes& other : {
             Bytes{}, joined({{0x05, 0x01}, kDisplay, kBytes, kPage, cells(20), kEnd}),            // another thing's cells
             joined({kPage, kDisplay, kBytes, keys(20), kEnd}),                                    // keys alone
             joined({kPage, kDisplay, bits, cells(160), kEnd}),                                    // a bit for each cell
             joined({kPage, kDisplay, {0x75, 0x04}, cells(1, 9), {0x75, 0x08}, cells(20), kEnd}),  // from the middle of a byte
             joined({kPage, kDisplay, kBytes, fixed, kEnd}), joined({kPage, kDisplay, kBytes, cells(0), kEnd}),
             joined({kPage, {0x09, 0x02}, {0xA1, 0x01}, kBytes, cells(20), kEnd}),
             joined({kPage, kDisplay, kBytes, kEnd, cells(20)}),  // behind it
         })
        EXPECT_TRUE(braille_reports(other).lines.empty());
}

TEST(BrailleReports, BrokenOnesAreRefused) {
    const Bytes whole = joined({kPage, kDisplay, kBytes, report(1), kRow, cells(40), kEnd, kEnd});
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_TRUE(braille_reports(std::span(whole).first(size)).lines.empty()) << size;
    for (const Bytes& part : {Bytes{0xC0}, Bytes{0xB4}, Bytes{0x85, 0x00}, Bytes{0x86, 0x00, 0x01}, Bytes{0xFE, 0xFF, 0x00},
                              Bytes{0xFE}, Bytes{0x75, 0x08, 0x97, 0xFF, 0xFF, 0xFF, 0xFF, 0x91, 0x02},
                              Bytes{0x77, 0xFF, 0xFF, 0xFF, 0xFF, 0x97, 0xFF, 0xFF, 0xFF, 0xFF, 0x91, 0x02}})
        EXPECT_TRUE(braille_reports(joined({part, whole})).lines.empty());
    EXPECT_TRUE(braille_reports(joined({Bytes(100, 0xA4), whole})).lines.empty());
    EXPECT_TRUE(braille_reports(Bytes(1'000'000, 0xA4)).lines.empty());
    std::mt19937 random(3);
    for (int trial = 0; trial < 20'000; ++trial) {
        Bytes broken = whole;
        for (int i = 0; i < 3; ++i) broken[random() % broken.size()] = static_cast<std::uint8_t>(random());
        const BrailleReports reports = braille_reports(broken);
        for (const auto& line : reports.lines) {
            ASSERT_TRUE(reports.sizes.contains(line.report));
            ASSERT_LE(line.begin + static_cast<std::size_t>(reports.columns), reports.sizes.at(line.report));
            ASSERT_LE(reports.sizes.at(line.report), 16'384u);
        }
    }
}

class HidDisplays : public testing::Test {
protected:
    void put(const std::string& name, const Bytes& descriptor) {
        const auto device = folder.path() / "sys/class/hidraw" / name / "device";
        std::filesystem::create_directories(device);
        tests::write_bytes(device / "report_descriptor", std::string(descriptor.begin(), descriptor.end()));
        tests::write_bytes(device / "uevent",
                           "DRIVER=hid-generic\nHID_ID=0003:00001C71:0000C00A\nHID_NAME=Dots of " + name + "\nHID_UNIQ=\n");
    }
    const tests::Folder folder;
    const std::string root = folder.path().string();
    const Bytes display = joined({kPage, kDisplay, kBytes, kRow, cells(20), kEnd, kRow, cells(20), kEnd, kEnd});
};

TEST_F(HidDisplays, AreReadFromWhatTheKernelLists) {
    put("hidraw0", {0x05, 0x01, 0x09, 0x06, 0xA1, 0x01, 0xC0});
    EXPECT_THROW(hid_display("", root), Error);
    put("hidraw1", display);
    EXPECT_EQ(hid_display("", root).path, "/dev/hidraw1");
    EXPECT_EQ(hid_display("/dev/hidraw1", root).name, "Dots of hidraw1");
    EXPECT_THROW(hid_display("/dev/hidraw0", root), Error);
    put("hidraw2", display);
    EXPECT_EQ(hid_display("/dev/hidraw2", root).reports.lines.size(), 2u);
    try {
        hid_display("", root);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_TRUE(
            tests::holds(error.what(), "/dev/hidraw1 (Dots of hidraw1), /dev/hidraw2 (Dots of hidraw2); name one of them"))
            << error.what();
    }
}

TEST_F(HidDisplays, ThatMayNotBeOpenedAreListedWithTheirRule) {
    put("hidraw0", display);
    put("hidraw1", display);
    std::filesystem::create_directories(folder / "dev");
    tests::write_bytes(folder / "dev/hidraw0", "");
    const auto list = [&] {
        std::string text;
        for (const AttachedDevice& device : attached_devices(root)) text += device.address + ": " + device.note.english() + "\n";
        return text;
    };
    EXPECT_EQ(list(),
              "hid:/dev/hidraw0: braille display of 20 x 2 cells\n"
              "hid:/dev/hidraw1: braille display of 20 x 2 cells; the kernel names it, but there is no /dev/hidraw1\n");
    // A person without its rights.
    chmod(root.c_str(), 0755);
    chmod((folder / "dev/hidraw0").c_str(), 0);
    const auto as_nobody = [&] {
        if (geteuid() == 0 && setuid(65'534) != 0) std::_Exit(3);
        const std::string text = list();
        std::fputs(text.c_str(), stderr);
        std::_Exit(0);
    };
    EXPECT_EXIT(
        as_nobody(), testing::ExitedWithCode(0),
        "hidraw0: braille display of 20 x 2 cells; you are not permitted to use it; sudo setfacl -m u:.USER:rw /dev/hidraw0 "
        "permits it "
        "until it is unplugged; for good write this line into /etc/udev/rules.d/70-tactics-display.rules: "
        "KERNEL==\"hidraw.\", ATTRS.idVendor.==\"1c71\", ATTRS.idProduct.==\"c00a\", TAG.=\"uaccess\", and plug it in again");
}

TEST_F(HidDisplays, TheirRuleIsMadeOfNumbersOnly) {
    const auto rule = [](const std::string& id) {
        const std::string text = how_to_be_permitted({"/dev/hidraw3", "", {}, id}).english();
        const auto at = text.find("KERNEL==");
        return at == std::string::npos ? "" : text.substr(at, text.rfind(", and") - at);
    };
    EXPECT_EQ(rule("0003:00001C71:0000C00A"),
              "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"1c71\", ATTRS{idProduct}==\"c00a\", TAG+=\"uaccess\"");
    EXPECT_EQ(rule("0005:00001C71:0000C00A"), "KERNEL==\"hidraw*\", KERNELS==\"0005:1C71:C00A.*\", TAG+=\"uaccess\"");
    for (const char* odd :
         {"", "0003", "0003:00001C71:0000C00", "0003:00001C71:0000C0\"A", "0003:0000 C71:0000C00A", "00\"3:00001C71:0000C00A"})
        EXPECT_EQ(rule(odd), "");
    EXPECT_TRUE(tests::holds(how_to_be_permitted({"/dev/hidraw3", "", {}, ""}).english(), "setfacl -m u:$USER:rw /dev/hidraw3"));
}

TEST_F(HidDisplays, AMouseIsPermittedByItsNumbers) {
    Bytes other(kMouseDescriptor.begin(), kMouseDescriptor.end());
    put("hidraw0", other);
    ++other[4];  // its usage
    put("hidraw1", other);
    EXPECT_EQ(hid_paths(kMouseUsagePage, kMouseUsage, root), std::vector<std::string>{"/dev/hidraw0"});
    const std::string text = how_to_be_permitted("/dev/hidraw0", root).english();
    EXPECT_TRUE(tests::holds(text, "setfacl -m u:$USER:rw /dev/hidraw0")) << text;
    EXPECT_TRUE(tests::holds(
        text,
        "70-tactics-mouse.rules: KERNEL==\"hidraw*\", ATTRS{idVendor}==\"1c71\", ATTRS{idProduct}==\"c00a\", TAG+=\"uaccess\""))
        << text;
}

}  // namespace
}  // namespace tactics::braille_reports_test
