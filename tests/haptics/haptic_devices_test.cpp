// SPDX-License-Identifier: Apache-2.0
// Haptic mice and touch overlays, found in what a kernel lists.
#include "tactics/haptics/devices/haptic_devices.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "tactics/haptics/devices/mouse_report.h"
#include "tests/cli/tool.h"

namespace tactics::haptic_devices_test {
namespace {

class HapticDevices : public testing::Test {
protected:
    void SetUp() override {
        put("sys/class/hidraw/hidraw0/device/report_descriptor", std::string("\x05\x01\x09\x06\xA1\x01\xC0", 7));  // a keyboard
        put("sys/class/hidraw/hidraw3/device/report_descriptor", std::string(kMouseDescriptor.begin(), kMouseDescriptor.end()));
        put("sys/class/hidraw/hidraw3/device/uevent", "HID_ID=0003:00001209:0000ABCD\nHID_NAME=A mouse\n");
        overlay("event5", "2");
        overlay("event6", "5");  // a touch pad
    }
    void put(const std::string& name, const std::string& text) {
        std::filesystem::create_directories((folder / name).parent_path());
        tests::write_bytes(folder / name, text);
    }
    void overlay(const std::string& event, const std::string& properties) {
        const std::string device = "sys/class/input/" + event + "/device/";
        put(device + "name", "Infrared frame\n");
        put(device + "properties", properties + "\n");
        put(device + "capabilities/abs", "260800000000003\n");
    }
    std::string list() {
        std::string text;
        for (const AttachedDevice& device : haptic_devices(root))
            text += device.address + " | " + device.id + " | " + device.note.english() + "\n";
        return text;
    }
    const tests::Folder folder;
    const std::string root = folder.path().string();
};

TEST_F(HapticDevices, AreListedWithWhatToWrite) {
    put("dev/hidraw3", "");
    put("dev/input/event5", "");
    EXPECT_EQ(list(),
              "hid:/dev/hidraw3 | A mouse | haptic mouse: play --device hid:/dev/hidraw3\n"
              "/dev/input/event5 | Infrared frame | touch overlay or touch screen: play --overlay /dev/input/event5\n");
}

TEST_F(HapticDevices, ThatCannotBeUsedAreListedWithWhy) {
    EXPECT_EQ(list(),
              "hid:/dev/hidraw3 | A mouse | haptic mouse: play --device hid:/dev/hidraw3; the kernel names it, but there is no "
              "/dev/hidraw3\n"
              "/dev/input/event5 | Infrared frame | touch overlay or touch screen: play --overlay /dev/input/event5; "
              "the kernel names it, but there is no /dev/input/event5\n");
    put("dev/hidraw3", "");
    put("dev/input/event5", "");
    // A person without rights to them.
    chmod(root.c_str(), 0755);
    chmod((folder / "dev/hidraw3").c_str(), 0444);  // to be told is not enough
    chmod((folder / "dev/input/event5").c_str(), 0);
    const auto as_nobody = [&] {
        if (geteuid() == 0 && setuid(65'534) != 0) std::_Exit(3);
        std::fputs(list().c_str(), stderr);
        std::_Exit(0);
    };
    EXPECT_EXIT(as_nobody(), testing::ExitedWithCode(0),
                "hidraw3; you are not permitted to use it; sudo setfacl -m u:.USER:rw /dev/hidraw3 .*70-tactics-mouse.rules: "
                "KERNEL==\"hidraw.\", ATTRS.idVendor.==\"1209\".*\n"
                ".*event5; you are not permitted to use it; sudo setfacl -m u:.USER:r /dev/input/event5 permits it");
}

TEST_F(HapticDevices, NoneIsThereWhereNothingIsListed) { EXPECT_TRUE(haptic_devices((folder / "nothing").string()).empty()); }

}  // namespace
}  // namespace tactics::haptic_devices_test
