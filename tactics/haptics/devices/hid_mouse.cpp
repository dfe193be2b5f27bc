// A mouse with the reports of mouse_report.h.
#include <algorithm>
#include <chrono>

#include "tactics/error.h"
#include "tactics/haptics/device_clock.h"
#include "tactics/haptics/mouse_devices.h"
#include "tactics/haptics/mouse_report.h"
#include "tactics/transport/hid_reports.h"

namespace tactics {

namespace {

constexpr std::uint16_t kUsagePage = 0xFF54;
constexpr std::uint8_t kUsage = 0x01;
// A force holds no longer than this without another; then the mouse lets go by itself.
constexpr unsigned kHold = 3;  // ms
constexpr int kMostQueued = 256;  // reports taken in one tick; what is older is of no use

std::string path_of(const std::string& wished) {
    const std::vector<std::string> paths = hid_paths(kUsagePage, kUsage, "");
    if (!wished.empty()) return wished;
    if (paths.empty()) throw Error(Fault::failed, "hid", "there is no haptic mouse; plug it in, or name it, --device hid:/dev/hidraw0; see tactics help play");
    if (paths.size() == 1) return paths[0];
    std::string all;
    for (const std::string& path : paths) all += (all.empty() ? "" : ", ") + ("hid:" + path);
    throw Error(Fault::failed, "hid", "several haptic mice are there: " + all + "; name one of them");
}

class HidMouse : public MouseDevice {
public:
    HidMouse(std::string path, const HidMouseSettings& settings) : path_(std::move(path)), settings_(settings), reports_(open_hid_reports(path_)) {}
    // The finger is let go.
    ~HidMouse() override { send(0, false); }
    HidMouse(const HidMouse&) = delete;
    HidMouse& operator=(const HidMouse&) = delete;

    State read(MouseSample& sample, double) noexcept override {
        if (reports_ == nullptr) return State::gone;
        ReportBytes bytes{};
        bool any = false;
        sample.moved = {sample.moved.time, {}, {}};
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

    bool push(double force) noexcept override { return reports_ != nullptr && send(force, true); }
    bool is_real() const override { return true; }

    bool reopen() override {
        try {
            reports_ = open_hid_reports(path_);
            clock_.restart();
            return true;
        } catch (const Error&) {
            return false;  // not yet
        }
    }

private:
    void take(const MouseReport& report, MouseSample& sample) noexcept {
        const auto mm = [&](std::int16_t counts) { return counts / settings_.counts_per_mm; };
        sample.moved.first.x += mm(report.first_x);
        sample.moved.first.y += mm(report.first_y);
        sample.moved.second.x += mm(report.second_x);
        sample.moved.second.y += mm(report.second_y);
        // By CLOCK_MONOTONIC, which is what an overlay tells, too.
        const double arrival = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
        sample.moved.time = clock_.time(report.microseconds, arrival);
        sample.height = report.encoder * settings_.encoder_step;
        sample.stop_key = sample.stop_key || report.stop_key;
        sample.fault = report.fault;
    }

    bool send(double force, bool motor_on) noexcept {
        if (reports_ == nullptr) return false;
        const ReportBytes bytes = bytes_of(ForceReport{motor_on, number_++, force, kHold});
        if (reports_->write(bytes)) return true;
        reports_.reset();
        return false;
    }

    std::string path_;
    HidMouseSettings settings_;
    std::unique_ptr<HidReports> reports_;
    std::uint8_t number_ = 0;
    DeviceClock clock_;
};

}  // namespace

std::unique_ptr<MouseDevice> hid_mouse(const std::string& path, const HidMouseSettings& settings) { return std::make_unique<HidMouse>(path_of(path), settings); }

}  // namespace tactics
