// SPDX-License-Identifier: Apache-2.0
// A simulated mouse that does not know its place, like a real one.
#include <algorithm>

#include "tactics/error.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/haptics/simulated/pointing.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::uint64_t kSeed = 1;  // equal calls give equal bytes

class SensedMouse : public HapticDevice {
public:
    SensedMouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger, const SensedWish& wish)
        : lever_(lever, finger, wish.begin_height),
          pointing_(to_and_fro({0, wish.height / 2}, {wish.width, wish.height / 2}, wish.speed, wish.seconds)),
          sensed_(sense(pointing_, wish.geometry, all_causes(), kSeed, wish.rate)),
          seconds_(std::min(wish.seconds, pointing_.end())) {}

    State read(HapticSample& sample, double dt) noexcept override {
        lever_.advance(std::clamp(dt, 0.0, 1.0));
        time_ += dt;
        if (time_ > seconds_) return State::over;
        sample.moved = {time_, {}, {}};
        const auto add = [](Point& sum, Point more) { sum = {sum.x + more.x, sum.y + more.y}; };
        for (; step_ < sensed_.steps.size() && sensed_.steps[step_].time <= time_; ++step_) {
            add(sample.moved.first, sensed_.steps[step_].first);
            add(sample.moved.second, sensed_.steps[step_].second);
        }
        sample.has_overlay = false;
        for (; next_ < sensed_.samples.size() && sensed_.samples[next_].time <= time_; ++next_) {
            sample.has_overlay = true;
            sample.overlay = sensed_.samples[next_];
        }
        sample.place = pointing_.at(time_).at;
        sample.height = lever_.height();
        return State::fine;
    }
    bool push(const Point3& force) noexcept override {
        lever_.push(force.z);
        return true;
    }

private:
    SimulatedLever lever_;
    Pointing pointing_;
    Sensed sensed_;
    double time_ = 0, seconds_;
    std::size_t step_ = 0, next_ = 0;
};

}  // namespace

std::unique_ptr<HapticDevice> sensed_mouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger,
                                           const SensedWish& wish) {
    return std::make_unique<SensedMouse>(lever, finger, wish);
}

namespace {

std::unique_ptr<HapticDevice> open_sensed(const DeviceWish& wish) {
    if (wish.seconds > kMostSensed)
        throw Error(Fault::usage, spelled("seconds"),
                    phrase("a sensed mouse is simulated for at most {0} s", numeral(kMostSensed)));
    const HeightMap& map = wish.surface->map();
    return sensed_mouse(wish.machine.lever, wish.machine.on_it(),
                        {geometry_of(wish.machine.sensors), map.width(), map.height(),
                         wish.surface->height({0, map.height() / 2}), wish.speed, wish.seconds, wish.machine.lever.rate_hz});
}

}  // namespace

extern const DeviceKind sensed_device;
const DeviceKind sensed_device{.name = "sensed",
                               .example = "sensed",
                               .has_hand = true,
                               .finds_place = true,
                               .knows_truth = true,
                               .ends = true,
                               .open = open_sensed};

}  // namespace tactics
