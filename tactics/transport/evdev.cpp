// SPDX-License-Identifier: Apache-2.0
// Touch devices through libevdev, which repeats events that the kernel had to drop.
#include <fcntl.h>
#include <libevdev/libevdev.h>
#include <time.h>

#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

#include "tactics/error.h"
#include "tactics/transport/descriptor.h"
#include "tactics/transport/kernel_lists.h"
#include "tactics/transport/touch_device.h"

namespace tactics {

namespace {

constexpr int kMostEvents = 4096;  // taken in one read; a device that sends more is heard in the next

struct FreeDevice {
    void operator()(libevdev* device) const { libevdev_free(device); }
};
using Device = std::unique_ptr<libevdev, FreeDevice>;

void say_nothing(const libevdev*, libevdev_log_priority, void*, const char*, int, const char*, const char*, va_list) {}

Descriptor open_input(const std::string& path) {
    const int number = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (number >= 0) return Descriptor(number);
    const int fault = errno;
    if (fault == EACCES || fault == EPERM) throw Error(Fault::failed, path, how_to_be_permitted_to_touch(path));
    if (fault == ENOENT || fault == ENODEV || fault == ENXIO)
        throw Error(Fault::failed, path,
                    phrase("there is no such device; plug it in, or find its name in /proc/bus/input/devices (event and a "
                           "number, below /dev/input)"));
    throw Error(Fault::failed, path, phrase("cannot be opened: {0}", std::strerror(fault)));
}

TouchAxis axis_of(const libevdev* device, unsigned code, const std::string& path) {
    const input_absinfo* axis = libevdev_get_abs_info(device, code);
    if (axis == nullptr || axis->maximum <= axis->minimum)
        throw Error(Fault::failed, path,
                    phrase("its axes have no range, so its places cannot be told in mm; unplug it and plug it in again, or name "
                           "another overlay"));
    return {axis->minimum, axis->maximum, axis->resolution > 0 ? static_cast<double>(axis->resolution) : 0};
}

class Evdev : public TouchDevice {
public:
    Evdev(const std::string& path, Descriptor descriptor) : descriptor_(std::move(descriptor)), device_(libevdev_new()) {
        if (device_ == nullptr) throw std::bad_alloc();
        libevdev_set_device_log_function(device_.get(), say_nothing, LIBEVDEV_LOG_ERROR, nullptr);
        if (libevdev_set_fd(device_.get(), descriptor_.number()) < 0)
            throw Error(Fault::failed, path,
                        phrase("is no input device; an overlay is one of /dev/input/event0, event1 ...; find its name in "
                               "/proc/bus/input/devices"));
        const auto has = [&](unsigned code) { return libevdev_has_event_code(device_.get(), EV_ABS, code) != 0; };
        by_slots_ = has(ABS_MT_POSITION_X) && has(ABS_MT_POSITION_Y) && libevdev_get_num_slots(device_.get()) > 0;
        if (!by_slots_ && !(has(ABS_X) && has(ABS_Y) && libevdev_has_event_code(device_.get(), EV_KEY, BTN_TOUCH) != 0))
            throw Error(
                Fault::failed, path,
                phrase(
                    "is no touch device but \"{0}\"; name one that tells where it is touched; find it in /proc/bus/input/devices",
                    libevdev_get_name(device_.get())));
        x_ = axis_of(device_.get(), by_slots_ ? ABS_MT_POSITION_X : ABS_X, path);
        y_ = axis_of(device_.get(), by_slots_ ? ABS_MT_POSITION_Y : ABS_Y, path);
        if (libevdev_set_clock_id(device_.get(), CLOCK_MONOTONIC) < 0)
            throw Error(
                Fault::failed, path,
                phrase("its events cannot be timed by CLOCK_MONOTONIC, to which a mouse is compared; use a kernel from 3.4 on"));
        take_what_is_down();
        // Otherwise the hand on the mouse would move the pointer and click. If exclusive use is impossible, the device is shared;
        // if another program has grabbed it, only that program receives events until it lets go.
        libevdev_grab(device_.get(), LIBEVDEV_GRAB);
    }
    ~Evdev() override { libevdev_grab(device_.get(), LIBEVDEV_UNGRAB); }
    Evdev(const Evdev&) = delete;
    Evdev& operator=(const Evdev&) = delete;

    TouchAxis x() const override { return x_; }
    TouchAxis y() const override { return y_; }

    State read(TouchFrame& frame) noexcept override {
        if (!begun_) {
            begun_ = true;
            // A resting finger causes no more events.
            timespec now{};
            clock_gettime(CLOCK_MONOTONIC, &now);
            frame = {static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec), contacts_.down()};
            if (!frame.contacts.empty()) return State::frame;
        }
        for (int i = 0; i < kMostEvents; ++i) {
            input_event event{};
            const int answer =
                libevdev_next_event(device_.get(), catching_up_ ? LIBEVDEV_READ_FLAG_SYNC : LIBEVDEV_READ_FLAG_NORMAL, &event);
            if (answer == -EAGAIN && catching_up_) {
                catching_up_ = false;
                continue;
            }
            if (answer == -EAGAIN || answer == -EINTR) return State::nothing;
            if (answer < 0) return State::gone;
            // The kernel has dropped events (SYN_DROPPED): the differences follow.
            if (answer == LIBEVDEV_READ_STATUS_SYNC) catching_up_ = true;
            if (!take(event)) continue;
            frame = {static_cast<double>(event.input_event_sec) + 1e-6 * static_cast<double>(event.input_event_usec),
                     contacts_.down()};
            return State::frame;
        }
        return State::nothing;
    }

private:
    void take_what_is_down() {
        libevdev* device = device_.get();
        if (!by_slots_) {
            contacts_.x(libevdev_get_event_value(device, EV_ABS, ABS_X));
            contacts_.y(libevdev_get_event_value(device, EV_ABS, ABS_Y));
            touch(libevdev_get_event_value(device, EV_KEY, BTN_TOUCH) != 0);
            return;
        }
        for (int slot = 0; slot < libevdev_get_num_slots(device) && slot < TouchContacts::kMost; ++slot) {
            const auto number = static_cast<unsigned>(slot);
            contacts_.slot(slot);
            contacts_.x(libevdev_get_slot_value(device, number, ABS_MT_POSITION_X));
            contacts_.y(libevdev_get_slot_value(device, number, ABS_MT_POSITION_Y));
            contacts_.tracking(libevdev_get_slot_value(device, number, ABS_MT_TRACKING_ID));
        }
        contacts_.slot(libevdev_get_current_slot(device));
    }

    void touch(bool down) noexcept { contacts_.tracking(down ? 1 : -1); }

    // True: the frame is complete.
    bool take(const input_event& event) noexcept {
        if (event.type == EV_SYN) return event.code == SYN_REPORT;
        if (event.type == EV_KEY && event.code == BTN_TOUCH && !by_slots_) touch(event.value != 0);
        if (event.type != EV_ABS) return false;
        switch (event.code) {
            case ABS_X:
                if (!by_slots_) contacts_.x(event.value);
                break;
            case ABS_Y:
                if (!by_slots_) contacts_.y(event.value);
                break;
            case ABS_MT_SLOT: contacts_.slot(event.value); break;
            case ABS_MT_TRACKING_ID: contacts_.tracking(event.value); break;
            case ABS_MT_POSITION_X: contacts_.x(event.value); break;
            case ABS_MT_POSITION_Y: contacts_.y(event.value); break;
            default: break;
        }
        return false;
    }

    Descriptor descriptor_;
    Device device_;
    bool by_slots_ = false, begun_ = false, catching_up_ = false;
    TouchAxis x_, y_;
    TouchContacts contacts_;
};

}  // namespace

Phrase how_to_be_permitted_to_touch(const std::string& path) {
    return phrase("you are not permitted to use it; sudo setfacl -m u:$USER:r {0} permits it until it is unplugged", path);
}

std::unique_ptr<TouchDevice> open_touch_device(const std::string& path) {
    return std::make_unique<Evdev>(path, open_input(path));
}

std::vector<TouchPlace> touch_places(const std::string& root) {
    std::vector<TouchPlace> places;
    for (const auto& entry : entries_of(root + "/sys/class/input")) {
        const std::string name = entry.filename().string();
        if (!name.starts_with("event")) continue;
        // Bits in hexadecimal, in words, the lowest last.
        const std::string properties = line_of(entry / "device/properties"), axes = line_of(entry / "device/capabilities/abs");
        const auto last = properties.find_last_of(' ');
        const unsigned long bits = std::strtoul(properties.c_str() + (last == std::string::npos ? 0 : last + 1), nullptr, 16);
        if ((bits >> INPUT_PROP_DIRECT & 1) == 0 || axes.empty() || axes == "0") continue;
        places.push_back({"/dev/input/" + name, line_of(entry / "device/name")});
    }
    return places;
}

}  // namespace tactics
