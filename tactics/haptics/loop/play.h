// SPDX-License-Identifier: Apache-2.0
// Plays a scene on a haptic device: from the device's sample to the force on the finger, once per tick.
#pragma once

#include <memory>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/loop/recorder.h"
#include "tactics/haptics/loop/safety.h"
#include "tactics/haptics/scenes/scene.h"
#include "tactics/haptics/sensing/fusion.h"
#include "tactics/haptics/sensing/velocity.h"

namespace tactics {

struct PlaySettings {
    double rate_hz = 1000;  ///< ticks per second
    SafetyLimits safety;
    std::size_t most_records = 1u << 20;  ///< of the last ticks
    Point begin;                          ///< mm, assumed position of the finger until an overlay reports it
};

class Playing {
public:
    /// `fusion` may be empty for a device that knows its place. Both must outlive it.
    Playing(Scene& scene, Fusion* fusion, const PlaySettings& settings);

    /// The force to apply now, N. A mouse applies its z. Nothing in it allocates, throws or waits.
    Point3 tick(const HapticSample& sample, double dt) noexcept;
    /// The device was away for that long, s, and let go of the finger: the force begins softly, from zero.
    void begin_again(double away) noexcept;
    /// From now on the force goes to zero (Safety::stop).
    void stop() noexcept { safety_.stop(); }
    bool stopped() const noexcept { return safety_.stopped(); }

    const Recorder& recorder() const noexcept { return recorder_; }
    const Safety& safety() const noexcept { return safety_; }
    unsigned reports_lost() const noexcept { return lost_; }  ///< reports lost by the device, by their numbers

private:
    Pose pose_of(const HapticSample& sample, double dt) noexcept;

    Scene& scene_;
    Fusion* fusion_;
    PlaySettings settings_;
    Safety safety_;
    Recorder recorder_;
    Pose known_;                      // of a device that knows its place
    double height_ = 0;               // mm, at the tick before
    AdaptiveVelocity course_, rise_;  // velocity over the map; vertical velocity, in the x component
    bool begun_ = false, overlaid_ = false;
    unsigned lost_ = 0;
    double time_ = 0, at_fault_ = 0;
};

}  // namespace tactics
