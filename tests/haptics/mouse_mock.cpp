// SPDX-License-Identifier: Apache-2.0
// A haptic mouse that is not there: runs a program that finds it as /dev/hidraw0, by umockdev.
//     umockdev-wrapper mouse_mock
//     FILE[,silent=N][,short=N][,magic=N][,sum=N][,random=N][,until=N][,stop=N][,fault=N][,gone=N][,back=MS]
//                                 [,interrupt=N][,mute][,keyboard][,second] PROGRAM...
// It sends a report for each force it receives, so that nothing depends on the speed of the machine. From the word N on (to the
// word `until`) it is silent, or its words are short, of another kind, with a wrong sum, or of random bytes; it says that the
// stop key is down, or fault; at the word N it is gone, for ever or until so many ms later, when it is /dev/hidraw1. Where it is
// interrupted the program gets SIGINT, and when it is gone for ever, a while later. A mute mouse says nothing and a keyboard is
// no mouse; these interrupt after 6 s. FILE gets a line for each force that is written: how many good words the program has had,
// of how many, and the report in hexadecimal.
#include <linux/hidraw.h>
#include <sched.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <random>

#include "tests/haptics/firmware.h"
#include "tests/tactics/transport/mocked_child.h"

namespace {

using namespace tactics;
using tests::Report;

constexpr long kNever = 1L << 40;
constexpr const char* kPlace = "/devices/usb1/1-1/1-1:1.0/0003:1209:0005.0001";
constexpr const char* kSecondPlace = "/devices/usb1/1-2/1-2:1.0/0003:1209:0005.0002";

struct Mouse {
    std::FILE* file = nullptr;
    UMockdevTestbed* testbed = nullptr;
    GPid child = 0;
    long silent = kNever, brief = kNever, magic = kNever, sum = kNever, random = kNever, until = kNever, stop = kNever,
         fault = kNever, gone = kNever, interrupt = kNever;
    long back = 0;  // ms; 0: never
    bool mute = false, keyboard = false, second = false;
    bool is_gone = false;
    int number = 0;                     // of hidraw
    long given = 0, good = 0, due = 1;  // words
    tests::Firmware firmware{2000, 1500};
    std::mt19937 generator{5};
};

std::string description(const Mouse& mouse, const std::string& device, int number) {
    std::string bytes = tests::in_hexadecimal(kMouseDescriptor);
    if (mouse.keyboard) bytes = "05010906A101" + bytes.substr(12);
    const std::string name = "hidraw" + std::to_string(number);
    return "P: " + device + "/hidraw/" + name + "\nN: " + name + "\nE: DEVNAME=/dev/" + name +
           "\nE: MAJOR=240\nE: MINOR=" + std::to_string(number) + "\nE: SUBSYSTEM=hidraw\nA: dev=240:" + std::to_string(number) +
           "\\n\nL: device=../../../" + device.substr(device.rfind('/') + 1) + "\n\nP: " + device +
           "\nE: DRIVER=hid-generic\nE: HID_ID=0003:00001209:00000005\nE: HID_NAME=Pretended Mouse\nE: SUBSYSTEM=hid\nH: "
           "report_descriptor=" +
           bytes + "\n";
}

gboolean interrupt(gpointer told) {
    kill(static_cast<Mouse*>(told)->child, SIGINT);
    return G_SOURCE_REMOVE;
}

gboolean asked(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer /*mouse*/) {
    // The player runs with real-time priority, if permitted; so does the mouse.
    sched_param first{};
    first.sched_priority = 50;
    sched_setscheduler(0, SCHED_FIFO, &first);
    tests::answer_descriptor(client, kMouseDescriptor);
    return TRUE;
}

gboolean come_back(gpointer told);

std::string device_of(const Mouse& mouse) { return "/dev/hidraw" + std::to_string(mouse.number); }

// The device of that name in umockdev is one end of a terminal. With an unread line in it, poll() finds it readable.
bool make_readable(const Mouse& mouse) {
    const int other_end = umockdev_testbed_get_dev_fd(mouse.testbed, device_of(mouse).c_str());
    return other_end >= 0 && write(other_end, "\n", 1) == 1;
}

void go(Mouse& mouse) {
    if (mouse.is_gone) return;
    mouse.is_gone = true;
    const std::string name = "hidraw" + std::to_string(mouse.number);
    umockdev_testbed_remove_device(mouse.testbed, ("/sys" + std::string(kPlace) + "/hidraw/" + name).c_str());
    umockdev_testbed_remove_device(mouse.testbed, ("/sys" + std::string(kPlace)).c_str());
    if (mouse.back > 0)
        g_timeout_add(static_cast<guint>(mouse.back), come_back, &mouse);
    else
        g_timeout_add(500, interrupt, &mouse);
}

// What the program may find of the next word, if one is due: nothing, all of it, a part, or something else.
std::size_t next_word(Mouse& mouse, Report& bytes) {
    if (mouse.given >= mouse.due || mouse.mute || mouse.keyboard) return 0;
    mouse.firmware.advance(0.001);
    mouse.firmware.stop_key = mouse.given >= mouse.stop;
    mouse.firmware.too_hot = mouse.given >= mouse.fault && mouse.given < mouse.until;
    bytes = mouse.firmware.report();
    const long word = mouse.given++;
    if (word == mouse.interrupt) interrupt(&mouse);
    const auto in = [&](long from) { return word >= from && word < mouse.until; };
    if (in(mouse.silent)) return 0;
    if (in(mouse.magic)) {
        bytes[0] = 0x55;
        tests::Firmware::seal(bytes);
    } else if (in(mouse.sum)) {
        bytes[9] ^= 4;
    } else if (in(mouse.random)) {
        for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(mouse.generator());
    } else if (!in(mouse.brief)) {
        ++mouse.good;
    }
    return in(mouse.brief) ? static_cast<std::size_t>(1 + word % 63) : bytes.size();
}

// The pretended file can always be read from: who has nothing says so.
gboolean wants(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer told) {
    auto& mouse = *static_cast<Mouse*>(told);
    UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    if (mouse.given >= mouse.gone && mouse.good > 0) go(mouse);
    if (mouse.is_gone) {
        umockdev_ioctl_client_complete(client, -1, ENODEV);
        return TRUE;
    }
    Report bytes{};
    const std::size_t size = std::min(next_word(mouse, bytes), static_cast<std::size_t>(data->data_len));
    if (size == 0) {
        umockdev_ioctl_client_complete(client, -1, EAGAIN);
        return TRUE;
    }
    umockdev_ioctl_data_update(data, 0, bytes.data(), static_cast<int>(size));
    umockdev_ioctl_client_complete(client, static_cast<long>(size), 0);
    return TRUE;
}

gboolean written(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer told) {
    auto& mouse = *static_cast<Mouse*>(told);
    if (mouse.is_gone) {
        umockdev_ioctl_client_complete(client, -1, ENODEV);
        return TRUE;
    }
    const UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    std::fprintf(mouse.file, "%ld %ld ", mouse.good, mouse.given);
    for (int i = 0; i < data->data_len; ++i) std::fprintf(mouse.file, "%02x", data->data[i]);
    std::fputc('\n', mouse.file);
    std::fflush(mouse.file);
    // The first byte is the number of the report, which has none.
    if (data->data_len == 65) mouse.firmware.obey({data->data + 1, 64});
    mouse.due = mouse.given + 1;
    umockdev_ioctl_client_complete(client, data->data_len, 0);
    return TRUE;
}

tests::Answers answers_of(Mouse& mouse) { return {G_CALLBACK(asked), G_CALLBACK(written), G_CALLBACK(wants), &mouse}; }

gboolean come_back(gpointer told) {
    auto& mouse = *static_cast<Mouse*>(told);
    ++mouse.number;
    mouse.is_gone = false;
    mouse.gone = kNever;
    mouse.due = mouse.given + 1;
    std::fputs("back\n", mouse.file);
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(mouse.testbed, description(mouse, kPlace, mouse.number).c_str(), &error) ||
        !make_readable(mouse) || !tests::answer_for(mouse.testbed, device_of(mouse).c_str(), answers_of(mouse), &error))
        tests::no_mock(error);
    return G_SOURCE_REMOVE;
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) return tests::kNoMock;
    Mouse mouse;
    char* word = std::strtok(words[1], ",");
    mouse.file = std::fopen(word, "w");
    while ((word = std::strtok(nullptr, ",")) != nullptr) {
        const std::string text = word, name = text.substr(0, text.find('='));
        const long value = text.size() > name.size() ? std::stol(text.substr(name.size() + 1)) : 0;
        const struct {
            const char* name;
            long* to;
        } numbers[] = {{"silent", &mouse.silent}, {"short", &mouse.brief},        {"magic", &mouse.magic},
                       {"sum", &mouse.sum},       {"random", &mouse.random},      {"until", &mouse.until},
                       {"stop", &mouse.stop},     {"fault", &mouse.fault},        {"gone", &mouse.gone},
                       {"back", &mouse.back},     {"interrupt", &mouse.interrupt}};
        for (const auto& one : numbers)
            if (name == one.name) *one.to = value;
        if (name == "mute") mouse.mute = true;
        if (name == "keyboard") mouse.keyboard = true;
        if (name == "second") mouse.second = true;
    }
    GError* error = nullptr;
    mouse.testbed = umockdev_testbed_new();
    if (!umockdev_testbed_add_from_string(mouse.testbed, description(mouse, kPlace, 0).c_str(), &error) || !make_readable(mouse))
        return tests::no_mock(error);
    if (mouse.second && !umockdev_testbed_add_from_string(mouse.testbed, description(mouse, kSecondPlace, 1).c_str(), &error))
        return tests::no_mock(error);
    if (mouse.mute || mouse.keyboard) g_timeout_add(6000, interrupt, &mouse);
    return tests::run_beside(mouse.testbed, "/dev/hidraw0", answers_of(mouse), words + 2, &mouse.child);
}
