// SPDX-License-Identifier: Apache-2.0
// A touch overlay that is not there, /dev/input/event0, and a haptic mouse, /dev/hidraw0: runs a program that finds them, by
// umockdev.
//     umockdev-wrapper overlay_mock KIND PROGRAM...
// KIND: slots, single, joystick, flat, taken: what the overlay is (taken: slots, and it cannot be grabbed); then it tells a few
// frames and is gone. Each grab of it is told on standard error. play, leaving: the mouse and the
// overlay tell of a hand that rests, goes 50 mm to the right and rests; leaving: the overlay is gone as the hand moves, and comes
// back. What is read from the overlay is answered by a handler (libevdev waits for nothing); hidapi waits for reports, so these
// go through the pseudo-terminal that umockdev has in the place of a device.
#include <linux/hidraw.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <ctime>
#include <vector>

#include "tactics/haptics/devices/mouse_report.h"
#include "tests/tactics/transport/mocked_child.h"

namespace {

using namespace tactics;

const std::string kDevices =
    "P: /devices/pci/input/input0/event0\nN: input/event0\nE: DEVNAME=/dev/input/event0\nE: MAJOR=13\nE: MINOR=64\nE: "
    "SUBSYSTEM=input\nA: dev=13:64\\n\n"
    "L: device=../../input0\n\n"
    "P: /devices/pci/input/input0\nE: SUBSYSTEM=input\nA: name=Pretended frame\\n\nA: properties=2\\n\nA: "
    "capabilities/abs=260800000000003\\n\n\n"
    "P: /devices/mouse/hidraw/hidraw0\nN: hidraw0\nE: DEVNAME=/dev/hidraw0\nE: MAJOR=240\nE: MINOR=0\nE: SUBSYSTEM=hidraw\nA: "
    "dev=240:0\\n\n"
    "L: device=../../../mouse\n\n"
    "P: /devices/mouse\nE: DRIVER=hid-generic\nE: HID_ID=0003:00001209:00000004\nE: HID_NAME=Pretended mouse\nE: "
    "SUBSYSTEM=hid\nH: report_descriptor=" +
    tests::in_hexadecimal(kMouseDescriptor) + "\n";

double now() { return 1e-6 * static_cast<double>(g_get_monotonic_time()); }

input_event event_of(int type, int code, int value, double time) {
    input_event event{};
    event.input_event_sec = static_cast<decltype(event.input_event_sec)>(time);
    event.input_event_usec = static_cast<decltype(event.input_event_usec)>(std::lround(1e6 * (time - std::floor(time))));
    event.type = static_cast<__u16>(type);
    event.code = static_cast<__u16>(code);
    event.value = value;
    return event;
}

// The hand: it rests for so long, goes to the right, and rests; how late the overlay is. s, mm/s
constexpr double kRest = 0.3, kGoing = 0.4, kSpeed = 125, kEnd = 2, kDelay = 0.15;
constexpr double kCountsPerMm = 31.5;
double way_at(double time) { return kSpeed * std::clamp(time - kRest, 0.0, kGoing); }

struct Overlay {
    std::string kind;
    int clock = CLOCK_REALTIME;
    struct Slot {
        int id = -1, x = 0, y = 0;
    } slots[2];
    std::vector<std::vector<input_event>> told;  // a read each; nothing in it: there is nothing to read
    std::size_t next = 0;
    double begun = 0, frame = 0;  // s
    bool by_slots() const { return kind != "single" && kind != "joystick"; }
    bool moves() const { return kind == "play" || kind == "leaving"; }
    int x_at(double time) const { return static_cast<int>(std::lround(10 * (60 + way_at(time - begun - kDelay)))); }
    bool away() const { return kind == "leaving" && begun > 0 && now() - begun > kRest && now() - begun < kRest + kGoing; }
};

std::vector<std::vector<input_event>> frames_of(const Overlay& overlay) {
    const auto at = [](double time, std::vector<std::array<int, 3>> all) {
        std::vector<input_event> events;
        for (const auto& [type, code, value] : all) events.push_back(event_of(type, code, value, time));
        events.push_back(event_of(EV_SYN, SYN_REPORT, 0, time));
        return events;
    };
    if (!overlay.by_slots())
        return {at(12.5, {{EV_ABS, ABS_X, 100}, {EV_ABS, ABS_Y, 200}, {EV_KEY, BTN_TOUCH, 1}}),
                {},
                at(12.516, {{EV_ABS, ABS_X, 110}}),
                at(12.6, {{EV_KEY, BTN_TOUCH, 0}})};
    // Slot 0 was down before; what is told of ABS_X is of a pointer, and no contact.
    auto frames = std::vector{at(12.5, {{EV_ABS, ABS_MT_POSITION_X, 1010}, {EV_ABS, ABS_X, 7}}),
                              {},
                              at(12.516, {{EV_ABS, ABS_MT_SLOT, 1},
                                          {EV_ABS, ABS_MT_TRACKING_ID, 8},
                                          {EV_ABS, ABS_MT_POSITION_X, 3000},
                                          {EV_ABS, ABS_MT_POSITION_Y, 4000}})};
    // The first goes and the second is elsewhere while the kernel drops events.
    frames.push_back({event_of(EV_SYN, SYN_DROPPED, 0, 12.6), event_of(EV_ABS, ABS_MT_POSITION_X, 99, 12.6),
                      event_of(EV_SYN, SYN_REPORT, 0, 12.6)});
    // libevdev reads before each event that it passes on, until there is nothing.
    for (int i = 0; i < 9; ++i) frames.push_back({});
    frames.push_back(at(12.7, {{EV_ABS, ABS_MT_POSITION_Y, 4020}}));
    frames.push_back({});
    frames.push_back({});
    return frames;
}

void set_bit(std::vector<guint8>& bits, unsigned bit) {
    if (bit / 8 < bits.size()) bits[bit / 8] = static_cast<guint8>(bits[bit / 8] | 1U << bit % 8);
}

std::vector<guint8> bits_of(const Overlay& overlay, unsigned type, std::size_t size) {
    std::vector<guint8> bits(size);
    if (type == 0)
        for (const unsigned one : {EV_SYN, EV_KEY, EV_ABS}) set_bit(bits, one);
    if (type == EV_KEY) set_bit(bits, overlay.kind == "joystick" ? BTN_TRIGGER : BTN_TOUCH);
    if (type != EV_ABS) return bits;
    for (const unsigned one : {ABS_X, ABS_Y}) set_bit(bits, one);
    if (overlay.by_slots())
        for (const unsigned one : {ABS_MT_SLOT, ABS_MT_POSITION_X, ABS_MT_POSITION_Y, ABS_MT_TRACKING_ID}) set_bit(bits, one);
    return bits;
}

input_absinfo axis_of(const Overlay& overlay, unsigned code) {
    input_absinfo axis{};
    axis.maximum = overlay.kind == "flat" ? 0 : 6000;
    axis.resolution = overlay.kind == "single" ? 0 : 10;
    if (code == ABS_MT_SLOT) axis = {overlay.slots[0].id < 0 ? 1 : 0, 0, 1, 0, 0, 0};
    if (code == ABS_MT_TRACKING_ID) axis = {0, 0, 65535, 0, 0, 0};
    return axis;
}

gboolean asked_overlay(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer told) {
    auto& overlay = *static_cast<Overlay*>(told);
    const unsigned long request = umockdev_ioctl_client_get_request(client);
    const unsigned number = _IOC_NR(request);
    const std::size_t size = _IOC_SIZE(request);
    const auto complete = [&](long result, int fault) {
        umockdev_ioctl_client_complete(client, result, fault);
        return TRUE;
    };
    if (_IOC_TYPE(request) != 'E') return complete(-1, ENOTTY);
    if (overlay.away()) return complete(-1, ENODEV);
    if (request == EVIOCGRAB) {  // its argument is a number
        const bool wanted = *reinterpret_cast<void* const*>(umockdev_ioctl_client_get_arg(client)->data) != nullptr;
        std::fputs(wanted ? "the overlay is grabbed\n" : "the overlay is let go\n", stderr);
        return overlay.kind == "taken" ? complete(-1, EBUSY) : complete(0, 0);
    }
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, size, nullptr);
    // The kernel answers with how many bytes there are, or with 0, and libevdev minds which.
    const auto answer = [&](const void* bytes, std::size_t length, bool counts = true) {
        std::memcpy(data->data, bytes, std::min(size, length));
        return complete(counts ? static_cast<long>(std::min(size, length)) : 0, 0);
    };
    if (number == 0x01) {
        const int version = EV_VERSION;
        return answer(&version, sizeof version, false);
    }
    if (number == 0x06) return answer("Pretended frame", 16);
    if (number == 0x07 || number == 0x08) return complete(-1, ENOENT);
    if (number == 0x09) return answer("\2", 1);
    if (number >= 0x20 && number < 0x40) return answer(bits_of(overlay, number - 0x20, size).data(), size);
    if (number == 0xa0) {
        std::memcpy(&overlay.clock, data->data, sizeof overlay.clock);
        return complete(0, 0);
    }
    if (number == 0x0a) {  // EVIOCGMTSLOTS
        std::vector<gint32> values(size / sizeof(gint32));
        std::memcpy(values.data(), data->data, size);
        if (overlay.moves() && overlay.begun > 0) overlay.slots[0].x = overlay.x_at(now());
        for (std::size_t i = 0; i < 2 && i + 1 < values.size(); ++i) {
            const auto& slot = overlay.slots[i];
            values[i + 1] = values[0] == ABS_MT_TRACKING_ID ? slot.id : values[0] == ABS_MT_POSITION_X ? slot.x : slot.y;
        }
        return answer(values.data(), size, false);
    }
    if (number >= 0x40 && number < 0x80) {
        const input_absinfo axis = axis_of(overlay, number - 0x40);
        return answer(&axis, sizeof axis, false);
    }
    std::memset(data->data, 0, size);  // ids, keys, lamps
    return complete(0, 0);
}

// Frames of the moving hand, 60 per second, with their delay; a resting hand causes no more frames.
std::vector<input_event> moving_frame(Overlay& overlay) {
    std::vector<input_event> events;
    const double time = now();
    if (overlay.begun <= 0 || time < overlay.frame) return events;
    overlay.frame = time + 1.0 / 60;
    const int x = overlay.x_at(time);
    if (x == overlay.slots[0].x) return events;
    overlay.slots[0].x = x;
    return {event_of(EV_ABS, ABS_MT_POSITION_X, x, time), event_of(EV_SYN, SYN_REPORT, 0, time)};
}

gboolean read_overlay(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer told) {
    auto& overlay = *static_cast<Overlay*>(told);
    std::vector<input_event> events;
    bool gone = overlay.away();
    if (overlay.moves())
        events = moving_frame(overlay);
    else if (overlay.next < overlay.told.size())
        events = overlay.told[overlay.next++];
    else
        gone = true;
    if (gone || events.empty()) {
        umockdev_ioctl_client_complete(client, -1, gone ? ENODEV : EAGAIN);
        return TRUE;
    }
    if (events[0].code == SYN_DROPPED && events[0].type == EV_SYN) {
        overlay.slots[0].id = -1;
        overlay.slots[1] = {8, 3500, 4000};
    }
    // The clock is what was asked for.
    if (overlay.clock != CLOCK_MONOTONIC)
        for (input_event& event : events) event.input_event_sec += 1000;
    UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    const std::size_t bytes = std::min(events.size() * sizeof(input_event), static_cast<std::size_t>(data->data_len));
    umockdev_ioctl_data_update(data, 0, reinterpret_cast<guint8*>(events.data()), static_cast<gint>(bytes));
    umockdev_ioctl_client_complete(client, static_cast<glong>(bytes), 0);
    return TRUE;
}

struct Mouse {
    Overlay* overlay;
    int device = -1;
    double told = 0;  // s, of the last report
    int counted = 0;
    int unread = 0;  // reports, at most
    bool opened = false;
};

gboolean asked_mouse(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer machine) {
    if (tests::answer_descriptor(client, kMouseDescriptor)) static_cast<Mouse*>(machine)->opened = true;
    return TRUE;
}

// In the queue of a terminal, which knows no reports and holds 4095 bytes.
constexpr int kMostUnread = 32;

// How long a program takes until it plays hangs on how busy the machine is: the hand rests until its first force.
gboolean written_mouse(UMockdevIoctlBase* /*base*/, UMockdevIoctlClient* client, gpointer machine) {
    auto& mouse = *static_cast<Mouse*>(machine);
    if (mouse.overlay->begun <= 0) mouse.overlay->begun = mouse.told = now();
    mouse.unread = 0;  // before a force it reads them all
    umockdev_ioctl_client_complete(client, umockdev_ioctl_client_get_arg(client)->data_len, 0);
    return TRUE;
}

bool tell(Mouse& mouse, double time) {
    MouseReport report;
    const int counts = static_cast<int>(std::lround(kCountsPerMm * way_at(time)));
    report.microseconds = static_cast<std::uint32_t>(static_cast<std::uint64_t>(1e6 * time + 4294e6));  // it runs over soon
    report.motor_on = true;
    report.encoder = 100;
    report.first_x = report.second_x = static_cast<std::int16_t>(counts - mouse.counted);
    report.stop_key = time > kEnd;
    mouse.counted = counts;
    ++mouse.unread;
    const ReportBytes bytes = bytes_of(report);
    return write(mouse.device, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
}

// A word when it is opened, for which a play waits; then what there was since, in steps of a millisecond.
gboolean tell_mouse(gpointer machine) {
    auto& mouse = *static_cast<Mouse*>(machine);
    const double begun = mouse.overlay->begun;
    if (begun <= 0) return !mouse.opened || mouse.unread > 0 || tell(mouse, 0);
    for (; mouse.told + 0.001 <= now() && mouse.unread < kMostUnread; mouse.told += 0.001)
        if (!tell(mouse, mouse.told - begun)) return FALSE;
    return TRUE;
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) return tests::kNoMock;
    Overlay overlay;
    overlay.kind = words[1];
    overlay.slots[0] = {7, 600, 500};
    if (!overlay.moves()) overlay.slots[0] = {7, 1000, 2000};
    overlay.told = frames_of(overlay);
    GError* error = nullptr;
    UMockdevTestbed* testbed = umockdev_testbed_new();
    if (!umockdev_testbed_add_from_string(testbed, kDevices.c_str(), &error)) return tests::no_mock(error);
    if (!tests::answer_for(testbed, "/dev/input/event0", {G_CALLBACK(asked_overlay), nullptr, G_CALLBACK(read_overlay), &overlay},
                           &error))
        return tests::no_mock(error);
    Mouse mouse{&overlay};
    mouse.device = umockdev_testbed_get_dev_fd(testbed, "/dev/hidraw0");
    g_timeout_add(1, tell_mouse, &mouse);
    return tests::run_beside(testbed, "/dev/hidraw0", {G_CALLBACK(asked_mouse), G_CALLBACK(written_mouse), nullptr, &mouse},
                             words + 2);
}
