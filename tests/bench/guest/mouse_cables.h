// SPDX-License-Identifier: Apache-2.0
// A haptic mouse at a kernel: its firmware, a process of its own that goes before all others as a device does, and what it hangs
// on.
#pragma once

#include <linux/uhid.h>
#include <sched.h>

#include <array>
#include <atomic>
#include <memory>
#include <random>

#include "tactics/haptics/loop/loop.h"
#include "tests/bench/guest/guest.h"
#include "tests/haptics/firmware.h"

namespace tactics::tests {

class Cable {
public:
    virtual ~Cable() = default;
    virtual void plug(bool in) = 0;
    virtual bool send(const Report& report, std::size_t size) = 0;  ///< false: the last has not gone yet
    virtual bool take(Report& report) = 0;                          ///< false: there is none
};

/// The kernel's HID and hidraw, without a bus.
class Uhid : public Cable {
public:
    void plug(bool in) override {
        if (in) return create(kMouseDescriptor);
        close(device_);
        device_ = -1;
    }
    void plug_keyboard() { create(kKeyboard); }
    bool send(const Report& report, std::size_t size) override {
        static uhid_event event{};
        event.type = UHID_INPUT2;
        event.u.input2.size = static_cast<__u16>(size);
        std::memcpy(event.u.input2.data, report.data(), size);
        return write(device_, &event, offsetof(uhid_event, u.input2.data) + size) > 0;
    }
    bool take(Report& report) override {
        static uhid_event event{};
        while (read(device_, &event, sizeof event) > 0) {
            if (event.type != UHID_OUTPUT || event.u.output.size != report.size() + 1) continue;
            std::memcpy(report.data(), event.u.output.data + 1, report.size());  // before it the number of the report
            return true;
        }
        return false;
    }

private:
    static constexpr unsigned char kKeyboard[] = {0x05, 0x01, 0x09, 0x06, 0xA1, 0x01, 0x75, 0x08,
                                                  0x95, 0x08, 0x09, 0x03, 0x91, 0x02, 0xC0};
    void create(std::span<const unsigned char> descriptor) {
        device_ = open("/dev/uhid", O_RDWR | O_NONBLOCK | O_CLOEXEC);
        uhid_event event{};
        event.type = UHID_CREATE2;
        std::strcpy(reinterpret_cast<char*>(event.u.create2.name), "Mouse");
        std::memcpy(event.u.create2.rd_data, descriptor.data(), descriptor.size());
        event.u.create2.rd_size = static_cast<__u16>(descriptor.size());
        event.u.create2.bus = 3;
        event.u.create2.vendor = 0x1209;
        event.u.create2.product = 5;
        if (write(device_, &event, sizeof event) < 0) std::printf("no uhid: %s\n", std::strerror(errno));
    }

    int device_ = -1;
};

/// A gadget on the kernel's pretended USB bus.
class Gadget : public Cable {
public:
    Gadget() {
        make_hid_gadget(kFolder, "0x0005", "Mouse", 64,
                        {reinterpret_cast<const char*>(kMouseDescriptor.data()), kMouseDescriptor.size()});
    }
    void plug(bool in) override {
        // It is closed first: the function of this kernel does not bear to lose its bus while it is in use.
        if (device_ >= 0) close(device_);
        device_ = -1;
        put(kFolder + "/UDC", in ? "dummy_udc.0" : "\n");
        if (in && is_there("/dev/hidg0")) device_ = open("/dev/hidg0", O_RDWR | O_NONBLOCK | O_CLOEXEC);
    }
    bool send(const Report& report, std::size_t size) override { return write(device_, report.data(), size) > 0; }
    bool take(Report& report) override {
        return read(device_, report.data(), report.size()) == static_cast<ssize_t>(report.size());
    }

private:
    const std::string kFolder = "/config/usb_gadget/mouse";
    int device_ = -1;
};

enum Says { words, brief, magic, sum, noise, nothing };

/// What the two processes tell each other.
struct Shared {
    // Wishes
    std::atomic<bool> plugged{false}, takes{true}, stop_key{false}, marked{false};  // marked: it says fault
    std::atomic<int> says{words};
    // What it did and felt
    std::atomic<bool> is_plugged{false}, motor_on{false};
    std::atomic<unsigned> sent{0}, refused{0}, obeyed{0}, broken{0}, faults{0};
    std::atomic<unsigned> after_mark{0};              // reports from the first with a mark to the first without force; 0: not yet
    std::atomic<double> good_word{0}, felt_force{0};  // s by its clock: when the last good word went, when a force was felt last
    std::atomic<double> most_force{0}, square{0}, sum{0},
        number{0};     // N; mm and mm^2 of the lever over the surface, where it had not just begun softly
    double began = 0;  // s from which on that is summed; set before it is plugged in
};

inline constexpr double kCounts = 31.5, kSpeed = 60, kFar = 100;  // a mm; mm/s; mm
inline double hills(double x) { return 6 + 3 * std::sin(0.25 * x); }

[[noreturn]] inline void run_firmware(Cable& cable, Shared& shared) {
    sched_param first{};
    first.sched_priority = 90;
    sched_setscheduler(0, SCHED_FIFO, &first);
    MonotonicClock clock(false);
    std::mt19937 random(9);
    std::unique_ptr<Firmware> firmware;
    unsigned mark = 0;
    double word = 0, soft = 0;  // s: when a force came last, and when it began softly last, as forces were long in coming
    double last = clock.now(), due = last;
    for (;;) {
        due = std::max(due + 0.001, clock.now() - 0.001);
        clock.wait_until(due);
        if (shared.plugged != shared.is_plugged) {
            cable.plug(shared.plugged);
            if (!firmware) firmware = std::make_unique<Firmware>(kSpeed * kCounts, kFar * kCounts);
            if (shared.plugged) last = due = clock.now();
            shared.is_plugged = shared.plugged.load();
        }
        const double now = clock.now(), passed = std::min(now - last, 0.05);
        last = now;
        if (!firmware) continue;
        const bool was_at_fault = firmware->is_at_fault();
        firmware->advance(passed);
        if (firmware->is_at_fault() && !was_at_fault) ++shared.faults;
        if (!shared.is_plugged) continue;
        Report bytes{};
        while (shared.takes && cable.take(bytes)) {
            ++(firmware->obey(bytes) ? shared.obeyed : shared.broken);
            if (now - word > 0.0045) soft = now;
            word = now;
        }
        const double force = firmware->force();
        if (force != 0) shared.felt_force = now;
        shared.most_force = std::max(shared.most_force.load(), std::abs(force));
        shared.motor_on = firmware->motor_on();
        if (now > shared.began && now > soft + 0.6 && firmware->motor_on() && shared.says == words && !shared.marked) {
            const double over = firmware->height() - hills(firmware->place() / kCounts);
            shared.square = shared.square + over * over;
            shared.sum = shared.sum + over;
            shared.number = shared.number + 1;
        }
        if (!shared.marked)
            mark = 0;
        else if (mark > 0 && force == 0 && shared.after_mark == 0)
            shared.after_mark = mark;
        firmware->stop_key = shared.stop_key;
        static Report report{};
        static std::size_t size = 0;  // of one that the bus has not taken yet
        if (size == 0) {
            report = firmware->report();
            size = report.size();
            if (shared.marked) {
                report[2] = static_cast<unsigned char>(report[2] | 4);
                Firmware::seal(report);
            }
            switch (shared.says.load()) {
                case brief: size = 1 + random() % 63; break;
                case magic:
                    report[0] = 0x45;
                    Firmware::seal(report);
                    break;
                case sum: report[10] ^= 1; break;
                case noise:
                    for (unsigned char& byte : report) byte = static_cast<unsigned char>(random());
                    break;
                case nothing: size = 0; break;
                default: break;
            }
        }
        if (size == 0) continue;
        if (!cable.send(report, size)) {
            ++shared.refused;
            continue;
        }
        size = 0;
        ++shared.sent;
        if (shared.says == words) shared.good_word = now;
        if (shared.marked) ++mark;
    }
}

}  // namespace tactics::tests
