// SPDX-License-Identifier: Apache-2.0
// Mice without a mouse: a simulated lever under a hand that goes to and fro, or that repeats a way.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tactics/error.h"
#include "tactics/haptics/devices/arm_devices.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/haptics/devices/recorded_way.h"
#include "tactics/readers/append_file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kSimulatedRest = 0.5;  // s that the hand rests at the edge while the force begins softly

class SimulatedMouse : public HapticDevice {
public:
    SimulatedMouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger, double begin_height, double seconds)
        : lever_(lever, finger, begin_height), seconds_(seconds) {}

    State read(HapticSample& sample, double dt) noexcept override {
        if (time_ > 0 || dt > 0) lever_.advance(std::clamp(dt, 0.0, 1.0));
        time_ += dt;
        if (time_ > seconds_) return State::over;
        sample.knows_place = true;
        sample.place = place_at(time_);
        sample.height = height_at(time_);
        return State::fine;
    }
    bool push(const Point3& force) noexcept override {
        lever_.push(force.z);
        return true;
    }

protected:
    virtual Point place_at(double time) noexcept = 0;
    virtual double height_at(double) noexcept { return lever_.height(); }

private:
    SimulatedLever lever_;
    double time_ = 0, seconds_;
};

class ToAndFro : public SimulatedMouse {
public:
    ToAndFro(const LeverSettings& lever, const std::optional<FingerSettings>& finger, double width, double height,
             double begin_height, double speed, double seconds)
        : SimulatedMouse(lever, finger, begin_height, seconds), width_(width), y_(height / 2), speed_(speed) {}

private:
    Point place_at(double time) noexcept override {
        const double way = std::fmod(std::max(0.0, time - kSimulatedRest) * speed_, 2 * width_);
        return {way < width_ ? way : 2 * width_ - way, y_};
    }
    double width_, y_, speed_;
};

class RecordedMouse : public SimulatedMouse {
public:
    RecordedMouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger, double begin_height, RecordedWay way)
        : SimulatedMouse(lever, finger, begin_height, way.end()), way_(std::move(way)) {}

private:
    Point place_at(double time) noexcept override {
        const Point3 at = way_.at(time);
        return {at.x, at.y};
    }
    double height_at(double time) noexcept override {
        return way_.has_height() ? way_.at(time).z : SimulatedMouse::height_at(time);
    }
    RecordedWay way_;
};

}  // namespace

std::unique_ptr<HapticDevice> simulated_mouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger,
                                              double width, double height, double begin_height, double speed, double seconds) {
    return std::make_unique<ToAndFro>(lever, finger, width, height, begin_height, speed, seconds);
}

std::unique_ptr<HapticDevice> recorded_mouse(std::string_view csv, const std::string& name, const LeverSettings& lever,
                                             const std::optional<FingerSettings>& finger, double begin_height) {
    return std::make_unique<RecordedMouse>(lever, finger, begin_height, read_way(csv, name));
}

namespace {

double begin_height(const ReliefSurface& surface) { return surface.height({0, surface.map().height() / 2}); }

std::unique_ptr<HapticDevice> open_simulated(const DeviceWish& wish) {
    const HeightMap& map = wish.surface->map();
    return simulated_mouse(wish.machine.lever, wish.machine.on_it(), map.width(), map.height(), begin_height(*wish.surface),
                           wish.speed, wish.seconds);
}

std::unique_ptr<HapticDevice> open_recorded(const DeviceWish& wish) {
    if (wish.where.empty()) throw Error(Fault::usage, spelled("device"), phrase("name the file of the way: recorded:hand.csv"));
    std::string csv;
    append_file(csv, wish.where);
    if (wish.axes == 3) return recorded_arm(csv, wish.where);
    return recorded_mouse(csv, wish.where, wish.machine.lever, wish.machine.on_it(), wish.surface->lowest());
}

}  // namespace

extern const DeviceKind simulated_device;
const DeviceKind simulated_device{
    .name = "simulated", .example = "simulated", .has_hand = true, .ends = true, .open = open_simulated};

extern const DeviceKind recorded_device;
const DeviceKind recorded_device{
    .name = "recorded", .address = "FILE.csv", .example = "recorded:FILE.csv", .axes = 0, .open = open_recorded};

}  // namespace tactics
