// SPDX-License-Identifier: Apache-2.0
// A scene played on a haptic mouse: from what the mouse tells to the force on the finger, once a tick.
#pragma once

#include <memory>

#include "tactics/haptics/devices/mouse_device.h"
#include "tactics/haptics/loop/recorder.h"
#include "tactics/haptics/loop/safety.h"
#include "tactics/haptics/scenes/scene.h"
#include "tactics/haptics/sensing/fusion.h"
#include "tactics/haptics/sensing/velocity.h"

namespace tactics {

struct PlaySettings {
    double rate_hz = 1000;  ///< ticks a second
    SafetyLimits safety;
    std::size_t most_records = 1u << 20;  ///< of the last ticks
    Point begin;                          ///< mm, where the finger is taken to be until an overlay has told
};

class MousePlay {
public:
    /// `fusion` may be empty for a device that knows its place. Both must outlive it.
    MousePlay(Scene& scene, Fusion* fusion, const PlaySettings& settings);

    /// The force to give now, N. Nothing in it allocates, throws or waits.
    double tick(const MouseSample& sample, double dt) noexcept;
    /// The mouse was away for so long, s, and let go of the finger: the force begins softly, from zero.
    void begin_again(double away) noexcept;
    /// From now on the force goes to zero (Safety::stop).
    void stop() noexcept { safety_.stop(); }
    bool stopped() const noexcept { return safety_.stopped(); }

    const Recorder& recorder() const noexcept { return recorder_; }
    const Safety& safety() const noexcept { return safety_; }
    unsigned reports_lost() const noexcept { return lost_; }  ///< of the mouse, by their numbers

private:
    Pose pose_of(const MouseSample& sample, double dt) noexcept;

    Scene& scene_;
    Fusion* fusion_;
    PlaySettings settings_;
    Safety safety_;
    Recorder recorder_;
    Pose known_;  // of a device that knows its place
    AdaptiveVelocity course_;
    bool begun_ = false, overlaid_ = false;
    unsigned lost_ = 0;
    double time_ = 0, at_fault_ = 0;
};

}  // namespace tactics
