// SPDX-License-Identifier: Apache-2.0
// A braille display of the HID standard that umockdev pretends.
#include <gtest/gtest.h>

#include "tests/cli/picture.h"
#include "tests/cli/tool.h"

namespace tactics::hid_test {
namespace {

using namespace tests;

class HidMock : public testing::Test {
protected:
    void SetUp() override {
#ifndef TACTICS_HID_MOCK
        GTEST_SKIP()
            << "libumockdev-dev is missing, or this is a build with sanitizers, which bear no other library before theirs";
#else
        if (!has_tool("umockdev-wrapper")) GTEST_SKIP() << "umockdev-wrapper is missing (package umockdev)";
#endif
    }
    Ending run(const std::string& mock, Words words) {
#ifdef TACTICS_HID_MOCK
        if (words.empty()) words = {TACTICS_HID_EXCHANGE};
        words.insert(words.begin(), {"umockdev-wrapper", TACTICS_HID_MOCK, "got" + mock});
#else
        (void)mock;
#endif
        return run_tool(folder, words);
    }
    Folder folder;
};

TEST_F(HidMock, GetsEveryCellInItsReport) {
    const Ending ending = run("", {});
    EXPECT_EQ(ending.code, 0) << ending.out << ending.err;
    EXPECT_EQ(ending.out, "20 x 3 of 8 dots\nkey 0\n");
    std::string expected;
    const auto add = [&](int number) {
        char text[3];
        std::snprintf(text, sizeof text, "%02x", number);
        expected += text;
    };
    add(1);
    for (int cell = 1; cell <= 40; ++cell) add(cell);
    expected += "\n";
    add(2);
    for (int cell = 41; cell <= 60; ++cell) add(cell);
    EXPECT_EQ(bytes_of(folder / "got"), expected + "\n");
}

TEST_F(HidMock, ShowsThePictureThatConvertWrites) {
    write_bytes(folder / "disc.tif", disc_picture());
    const Ending ending = run("", {TACTICS_PROGRAM, "show", "disc.tif", "--on", "hid:"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    ASSERT_EQ(run_tactics(folder, {"convert", "disc.tif", "-q", "-o", "braille-display:same.txt", "--set",
                                   "braille-display.columns=20", "--set", "braille-display.lines=3"})
                  .code,
              0);
    // A letter of Unicode braille is E2, A0 to A3, 80 to BF: its last eight bits are the cell.
    std::string expected = "01";
    const std::string text = bytes_of(folder / "same.txt");
    int cells = 0;
    for (std::size_t i = 0; i + 2 < text.size(); i += text[i] == '\n' ? 1 : 3) {
        if (text[i] == '\n') continue;
        if (cells++ == 40) expected += "\n02";
        char hex[3];
        std::snprintf(hex, sizeof hex, "%02x", ((text[i + 1] & 3) << 6) | (text[i + 2] & 0x3F));
        expected += hex;
    }
    EXPECT_EQ(cells, 60);
    EXPECT_EQ(bytes_of(folder / "got"), expected + "\n");
}

TEST_F(HidMock, UnpluggedIsTold) {
    const Ending ending = run(",gone=1", {});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.out, "/dev/hidraw0: the braille display is gone")) << ending.out;
}

TEST_F(HidMock, IsListedWithItsSize) {
    const Ending ending = run("", {TACTICS_PROGRAM, "devices"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(ending.out.substr(0, ending.out.find('\n')), "hid:/dev/hidraw0: Pretended Dots; braille display of 20 x 3 cells");
}

}  // namespace
}  // namespace tactics::hid_test
