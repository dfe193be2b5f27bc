// SPDX-License-Identifier: Apache-2.0
// A braille display of the HID standard that is not there: runs a program that finds it as /dev/hidraw0, by umockdev.
//     umockdev-wrapper hid_mock FILE[,gone=REPORTS] PROGRAM...
// FILE gets a line for each report that is written, in hexadecimal. After that many reports it is gone. It has 3 lines of 20
// cells: two rows in report 1, one in report 2. Keys are not simulated, because umockdev cannot wait for them.
#include <linux/hidraw.h>
#include <sys/ioctl.h>

#include <cerrno>
#include <cstring>

#include "tests/tactics/transport/mocked_child.h"

namespace {

using namespace tactics;

constexpr unsigned char kDescriptor[] = {
    0x05, 0x41, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x14, 0x85, 0x01, 0x09, 0x02,
    0xA1, 0x02, 0x09, 0x03, 0x91, 0x02, 0xC0, 0x09, 0x02, 0xA1, 0x02, 0x09, 0x03, 0x91, 0x02, 0xC0, 0x85, 0x02, 0x09,
    0x02, 0xA1, 0x02, 0x09, 0x03, 0x91, 0x02, 0xC0, 0x85, 0x03, 0x95, 0x01, 0x0A, 0x01, 0x02, 0x81, 0x02, 0xC0,
};

std::string description() {
    const std::string bytes = tests::in_hexadecimal(kDescriptor);
    const std::string device = "/devices/usb1/1-1/1-1:1.0/0003:1209:0003.0001";
    return "P: " + device +
           "/hidraw/hidraw0\nN: hidraw0\nE: DEVNAME=/dev/hidraw0\nE: MAJOR=240\nE: MINOR=0\nE: SUBSYSTEM=hidraw\nA: "
           "dev=240:0\\n\n"
           "L: device=../../../0003:1209:0003.0001\n\nP: " +
           device +
           "\nE: DRIVER=hid-generic\nE: HID_ID=0003:00001209:00000003\nE: HID_NAME=Pretended Dots\nE: SUBSYSTEM=hid\nH: "
           "report_descriptor=" +
           bytes + "\n";
}

struct Display {
    std::FILE* file = nullptr;
    long gone_at = 1L << 40, written = 0;
};

gboolean asked(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer /*display*/) {
    tests::answer_descriptor(client, kDescriptor);
    return TRUE;
}

gboolean written(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer told) {
    auto& display = *static_cast<Display*>(told);
    const UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    if (display.written++ >= display.gone_at) {
        umockdev_ioctl_client_complete(client, -1, ENODEV);
        return TRUE;
    }
    for (int i = 0; i < data->data_len; ++i) std::fprintf(display.file, "%02x", data->data[i]);
    std::fputc('\n', display.file);
    std::fflush(display.file);
    umockdev_ioctl_client_complete(client, data->data_len, 0);
    return TRUE;
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) return tests::kNoMock;
    Display display;
    const std::string what = words[1];
    display.file = std::fopen(what.substr(0, what.find(',')).c_str(), "w");
    if (const auto at = what.find(",gone="); at != std::string::npos) display.gone_at = std::stol(what.substr(at + 6));
    GError* error = nullptr;
    UMockdevTestbed* testbed = umockdev_testbed_new();
    if (!umockdev_testbed_add_from_string(testbed, description().c_str(), &error)) return tests::no_mock(error);
    return tests::run_beside(testbed, "/dev/hidraw0", {G_CALLBACK(asked), G_CALLBACK(written), nullptr, &display}, words + 2);
}
