// SPDX-License-Identifier: Apache-2.0
// A mouse with the reports of mouse_report.h.
#include <algorithm>
#include <chrono>
#include <filesystem>

#include "tactics/error.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/haptics/devices/mouse_report.h"
#include "tactics/haptics/sensing/device_clock.h"
#include "tactics/transport/hid_reports.h"

namespace tactics {

namespace {

constexpr int kMostQueued = 256;  // reports taken in one tick; the kernel keeps 64

// The path of the mouse: `wished`, a path or a link; or the only mouse; of several, the one that was `before`. After replugging,
// it may have another number, and its old one may be a keyboard. Empty: there is no mouse. Throws Error(failed).
std::string path_of(const std::string& wished, const std::string& before) {
    const std::vector<std::string> paths = hid_paths(kMouseUsagePage, kMouseUsage, "");
    const auto has = [&](const std::string& path) { return std::find(paths.begin(), paths.end(), path) != paths.end(); };
    if (!wished.empty()) {
        if (has(wished)) return wished;
        std::error_code fault;
        if (!std::filesystem::exists(wished, fault)) return "";
        // A udev rule can give it another name, which is a link.
        const std::string target = "/dev/" + std::filesystem::read_symlink(wished, fault).filename().string();
        if (has(target)) return target;
        throw Error(Fault::failed, wished,
                    phrase("it is no haptic mouse; hid: finds the one that is there; see tactics help play"));
    }
    if (paths.empty() || has(before)) return paths.empty() ? "" : before;
    if (paths.size() == 1) return paths[0];
    std::string all;
    for (const std::string& path : paths) all += (all.empty() ? "" : ", ") + ("hid:" + path);
    throw Error(Fault::failed, "hid", phrase("several haptic mice are there: {0}; name one of them", all));
}

class HidMouse : public HapticDevice {
public:
    HidMouse(std::string wished, const HidMouseSettings& settings) : wished_(std::move(wished)), settings_(settings) {
        if (!open())
            throw Error(
                Fault::failed, wished_.empty() ? "hid" : wished_,
                wished_.empty()
                    ? phrase("there is no haptic mouse; plug it in, or name it, {0} hid:/dev/hidraw0; see tactics help play",
                             spelled("device"))
                    : phrase("it is not there; plug the mouse in; hid: finds it by itself"));
    }
    ~HidMouse() override { let_go(); }
    HidMouse(const HidMouse&) = delete;
    HidMouse& operator=(const HidMouse&) = delete;

    State read(HapticSample& sample, double) noexcept override {
        if (reports_ == nullptr) return State::gone;
        ReportBytes bytes{};
        bool any = false;
        sample.moved = {sample.moved.time, {}, {}};
        sample.words = sample.lost = 0;
        for (int i = 0; i < kMostQueued; ++i) {
            const int count = reports_->read(bytes, std::chrono::milliseconds{0});
            if (count < 0) {
                reports_.reset();
                return State::gone;
            }
            if (count == 0) break;
            // What is short or damaged is as if it had not come.
            if (const auto report = mouse_report(std::span(bytes).first(static_cast<std::size_t>(count)))) {
                take(*report, sample);
                any = true;
            }
        }
        return any ? State::fine : State::nothing;
    }

    bool push(const Point3& force) noexcept override { return send(force.z, true); }
    bool is_real() const override { return true; }
    // But who has not said a word may not take one, either: the kernel would wait 5 s for it.
    void let_go() noexcept override {
        if (heard_) send(0, false);
        heard_ = false;
    }

    bool reopen(std::string& why) override {
        why.clear();
        try {
            return open();
        } catch (const Error& error) {
            why = error.what();
            return false;
        }
    }

private:
    bool open() {
        const std::string path = path_of(wished_, path_);
        if (path.empty()) return false;
        reports_ = open_hid_reports(path);
        path_ = path;
        clock_.restart();
        heard_ = false;
        return true;
    }

    void take(const MouseReport& report, HapticSample& sample) noexcept {
        const auto mm = [&](std::int16_t counts) { return counts / settings_.counts_per_mm; };
        sample.moved.first.x += mm(report.first_x);
        sample.moved.first.y += mm(report.first_y);
        sample.moved.second.x += mm(report.second_x);
        sample.moved.second.y += mm(report.second_y);
        // By CLOCK_MONOTONIC, as for an overlay.
        const double arrival = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
        sample.moved.time = clock_.time(report.microseconds, arrival);
        if (heard_) sample.lost += static_cast<std::uint8_t>(report.number - last_ - 1);
        ++sample.words;
        last_ = report.number;
        heard_ = true;
        sample.height = report.encoder * settings_.encoder_step;
        sample.stop_key = sample.stop_key || report.stop_key;
        sample.fault = report.fault;
    }

    bool send(double force, bool motor_on) noexcept {
        if (reports_ == nullptr) return false;
        const ReportBytes bytes = bytes_of(ForceReport{motor_on, number_++, force, kForceHold});
        if (reports_->write(bytes)) return true;
        reports_.reset();
        return false;
    }

    std::string wished_, path_;
    HidMouseSettings settings_;
    std::unique_ptr<HidReports> reports_;
    DeviceClock clock_;
    std::uint8_t number_ = 0, last_ = 0;
    bool heard_ = false;  // since it was opened
};

}  // namespace

std::unique_ptr<HapticDevice> hid_mouse(const std::string& path, const HidMouseSettings& settings) {
    return std::make_unique<HidMouse>(path, settings);
}

namespace {

std::unique_ptr<HapticDevice> open_hid(const DeviceWish& wish) {
    return hid_mouse(wish.where, {wish.machine.lever.encoder_step, wish.machine.sensors.counts_per_mm});
}

}  // namespace

extern const DeviceKind hid_device;
const DeviceKind hid_device{.name = "hid",
                            .address = "/dev/hidraw0",
                            .example = "hid:, hid:/dev/hidraw0",
                            .finds_place = true,
                            .real = true,
                            .open = open_hid};

}  // namespace tactics
