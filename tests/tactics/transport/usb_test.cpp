// SPDX-License-Identifier: Apache-2.0
// Printers on USB without the kernel's driver: how they are named, and the real program with one that umockdev pretends.
#include <gtest/gtest.h>

#include <fstream>

#include "tactics/error.h"
#include "tactics/transport/usb_printers.h"
#include "tests/cli/tool.h"

namespace tactics::usb_test {
namespace {

using namespace tests;

TEST(UsbPrinters, OneIsMeantOrAllThatCouldBeAreListed) {
    const Folder folder;
    const auto put = [&](const std::string& place, const std::string& interface, const std::string& serial,
                         const std::string& protocol) {
        const auto device = folder.path() / "sys/devices/usb1" / place, at = device / (place + interface);
        std::filesystem::create_directories(at);
        write_bytes(device / "idVendor", "12ab\n");
        write_bytes(device / "idProduct", "0002\n");
        write_bytes(device / "serial", serial + "\n");
        write_bytes(device / "product", "Everest " + serial + "\n");
        write_bytes(device / "busnum", "1\n");
        write_bytes(device / "devnum", "23\n");
        write_bytes(at / "bInterfaceClass", "07\n");
        write_bytes(at / "bInterfaceProtocol", protocol + "\n");
        std::filesystem::create_directories(folder.path() / "sys/bus/usb/devices");
        std::filesystem::create_directory_symlink(at, folder.path() / "sys/bus/usb/devices" / (place + interface));
    };
    put("1-2.3", ":1.0", "A:1", "02");
    put("1-2.3", ":1.1", "A:1", "01");  // a second interface of the same
    put("1-4", ":1.0", "B", "04");      // IPP takes no plain bytes
    const std::string root = folder.path().string();
    ASSERT_EQ(usb_printers(root).size(), 1u);
    EXPECT_EQ(usb_printer("", root).node(), "/dev/bus/usb/001/023");
    put("1-5", ":1.0", "C", "02");
    for (const char* choice : {"1-5", "12AB:0002:C"}) EXPECT_EQ(usb_printer(choice, root).place, "1-5") << choice;
    EXPECT_EQ(usb_printer("12ab:0002:A:1", root).place, "1-2.3");
    for (const char* choice : {"", "12ab:0002"}) {
        try {
            usb_printer(choice, root);
            ADD_FAILURE();
        } catch (const Error& error) {
            EXPECT_TRUE(holds(error.what(), "usb:1-2.3 (Everest A:1), usb:1-5 (Everest C); name one of them")) << error.what();
        }
    }
    for (const char* choice : {"1-4", "1-2", "12ab:0003", "12ab:0002:c"})
        EXPECT_THROW(usb_printer(choice, root), Error) << choice;
}

class UsbMock : public testing::Test {
protected:
    void SetUp() override {
#ifndef TACTICS_USB_MOCK
        GTEST_SKIP()
            << "libumockdev-dev is missing, or this is a build with sanitizers, which bear no other library before theirs";
#else
        if (!has_tool("umockdev-wrapper")) GTEST_SKIP() << "umockdev-wrapper is missing (package umockdev)";
#endif
        bytes.resize(300'001);
        for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 7 + i / 256);
        write_bytes(folder / "job.prn", bytes);
    }
    Ending run(const std::string& mock, Words words) {
#ifdef TACTICS_USB_MOCK
        words.insert(words.begin(), {"umockdev-wrapper", TACTICS_USB_MOCK, "got" + mock, TACTICS_PROGRAM});
#else
        (void)mock;
#endif
        return run_tool(folder, words);
    }
    Ending emboss(const std::string& mock, Words more = {}) {
        Words words{"emboss", "job.prn", "--to", "usb:"};
        words.insert(words.end(), more.begin(), more.end());
        return run(mock, words);
    }
    std::string got() const { return bytes_of(folder / "got"); }
    // What is told as accepted is what the printer has, and that is the beginning of the job.
    void expect_told(const Ending& ending) const {
        EXPECT_TRUE(holds(ending.err, std::to_string(got().size()) + " of 300001 bytes accepted")) << ending.err << got().size();
        EXPECT_TRUE(bytes.starts_with(got()));
        EXPECT_EQ(bytes_of(folder / "got.driver"), "-\n+\n");
    }
    Folder folder;
    std::string bytes;
};

TEST_F(UsbMock, GetsEveryByteOnceAndGivesTheDriverBack) {
    const Ending ending = emboss("");
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(got() == bytes);
    expect_told(ending);
    for (const char* choice : {"usb:1-1", "usb:1209:0002", "usb:1209:0002:SN1"})
        EXPECT_EQ(run("", {"emboss", "job.prn", "-q", "--to", choice}).code, 0) << choice;
    const Ending missing = run("", {"emboss", "job.prn", "--to", "usb:1-7"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_TRUE(holds(missing.err, "usb:1-7: there is no such printer on USB")) << missing.err;
}

TEST_F(UsbMock, UnpluggedIsToldWithWhatItTook) {
    for (const int at : {1, 4'096, 100'000, 234'567}) {
        const Ending ending = emboss(",unplug=" + std::to_string(at));
        EXPECT_EQ(ending.code, 5) << ending.err;
        EXPECT_EQ(got().size(), static_cast<std::size_t>(at));
        EXPECT_TRUE(holds(ending.err, "the machine is gone")) << ending.err;
        EXPECT_TRUE(holds(ending.err, std::to_string(at) + " of 300001 bytes accepted")) << ending.err;
        EXPECT_TRUE(bytes.starts_with(got()));
    }
}

TEST_F(UsbMock, TakingNothingEndsWhenPatienceDoes) {
    const Ending ending = emboss(",stop=100864", {"--wait", "0.3"});
    EXPECT_EQ(ending.code, 6) << ending.err;
    EXPECT_EQ(got().size(), 100'864u);
    expect_told(ending);
}

TEST_F(UsbMock, MissingPaperIsTold) {
    const Ending ending = emboss(",stop=70000,paper", {"--wait", "0.3"});
    EXPECT_EQ(ending.code, 4) << ending.err;
    EXPECT_TRUE(holds(ending.err, "put paper in, the job goes on by itself")) << ending.err;
    expect_told(ending);
}

// A transfer that was given up has left a part behind; what comes next begins there.
TEST_F(UsbMock, GoesOnAfterAPauseAndSendsNothingTwice) {
    const Ending ending = emboss(",stop=70000,for=2");
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(got() == bytes);
    expect_told(ending);
}

TEST_F(UsbMock, AStalledEndpointIsNotTriedAgain) {
    const Ending ending = emboss(",stall=50000");
    EXPECT_EQ(ending.code, 2) << ending.err;
    EXPECT_TRUE(holds(ending.err, "switch it off and on")) << ending.err;
    expect_told(ending);
}

TEST_F(UsbMock, SendsNothingToWhatIsBusyOrUnknown) {
    const Ending busy = emboss(",busy");
    EXPECT_EQ(busy.code, 2);
    EXPECT_TRUE(holds(busy.err, "is busy: another program has claimed it, perhaps CUPS; print to its queue instead")) << busy.err;
    EXPECT_EQ(got(), "");
    const Ending unknown = emboss(",id=MFG:HP;MDL:LaserJet;");
    EXPECT_EQ(unknown.code, 1);
    EXPECT_TRUE(holds(unknown.err, "is no embosser known here but \"MFG:HP;MDL:LaserJet;\"")) << unknown.err;
    EXPECT_EQ(got(), "");
    EXPECT_EQ(bytes_of(folder / "got.driver"), "");
    EXPECT_EQ(emboss(",id=MFG:HP;MDL:LaserJet;", {"--any-device"}).code, 0);
    EXPECT_TRUE(got() == bytes);
    const Ending several = emboss(",second");
    EXPECT_EQ(several.code, 2);
    EXPECT_TRUE(holds(several.err, "usb:1-1 (Index Braille Pretended), usb:1-2 (Index Braille Pretended); name one of them"))
        << several.err;
}

TEST_F(UsbMock, IsListedWithItsAddress) {
    const Ending ending = run("", {"devices"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.out, "usb:1-1: Index Braille Pretended; --embosser index-")) << ending.out;
    EXPECT_TRUE(holds(ending.out, "it is used directly")) << ending.out;
}

}  // namespace
}  // namespace tactics::usb_test
