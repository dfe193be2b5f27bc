// SPDX-License-Identifier: Apache-2.0
// An arm without an arm: a simulated one in which a hand's finger is, that feels its way (hand.h).
#include "tactics/haptics/devices/simulated_arm.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/error.h"
#include "tactics/haptics/devices/device_kind.h"

namespace tactics {

namespace {

constexpr double kSimulatedArmRest = 0.5;  // s that the hand rests while the force begins softly

class MovedArm final : public HapticDevice {
public:
    MovedArm(const ArmFile& arm, const Mounting& mounting, Hand& hand, double seconds)
        : mounting_(mounting),
          arm_(arm.arm, arm.in_it(), begin_of(arm.arm, mounting)),
          held_(arm.in_it().has_value()),
          hand_(hand),
          at_(begin_of(arm.arm, mounting)),
          seconds_(seconds) {}

    State read(HapticSample& sample, double dt) noexcept override {
        if (dt > 0) {
            const double passed = std::min(dt, 0.1);
            if (time_ > kSimulatedArmRest && held_) {
                const Point3 finger = mounting_.to_scene(arm_.place()), force = arm_.pushed();
                at_ = mounting_.to_device(hand_.move(
                    {finger, {dot(force, mounting_.right), dot(force, mounting_.down), dot(force, mounting_.out)}}, passed));
            }
            arm_.advance(passed, at_);
            time_ += dt;
        }
        if (time_ > seconds_ || hand_.is_done()) return State::over;
        const Point3 told = arm_.told();
        sample.knows_place = true;
        sample.place = {told.x, told.y};
        sample.height = told.z;
        sample.words = 1;
        sample.keys = hand_.keys();
        return State::fine;
    }
    bool push(const Point3& force) noexcept override {
        arm_.push(force);
        return true;
    }

private:
    // Over the middle of the workspace, almost at its side, where nothing is felt yet.
    static Point3 begin_of(const ArmSettings& arm, const Mounting& mounting) {
        double room = INFINITY;
        const auto bound = [&](double out, double size) {
            if (std::abs(out) > 1e-9) room = std::min(room, size / 2 / std::abs(out));
        };
        bound(mounting.out.x, arm.width);
        bound(mounting.out.y, arm.height);
        bound(mounting.out.z, arm.depth);
        return 0.9 * room * mounting.out;
    }

    Mounting mounting_;
    SimulatedArm arm_;
    bool held_;
    Hand& hand_;
    Point3 at_;
    double time_ = 0, seconds_;
};

std::unique_ptr<HapticDevice> open_arm(const DeviceWish& wish) {
    if (wish.hand == nullptr) throw std::logic_error("a simulated arm without a hand");
    return simulated_arm(wish.arm, wish.mounting, *wish.hand, wish.seconds);
}

}  // namespace

std::unique_ptr<HapticDevice> simulated_arm(const ArmFile& arm, const Mounting& mounting, Hand& hand, double seconds) {
    return std::make_unique<MovedArm>(arm, mounting, hand, seconds);
}

extern const DeviceKind arm_device;
const DeviceKind arm_device{.name = "arm", .example = "arm", .has_hand = true, .ends = true, .axes = 3, .open = open_arm};

}  // namespace tactics
