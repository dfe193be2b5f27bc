// SPDX-License-Identifier: Apache-2.0
// Where the finger is: a late absolute overlay and two optical sensors that only know how far they moved (1-DOF haptic mouse,
// V.A).
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "tactics/drawing.h"
#include "tactics/haptics/sensing/learned.h"

namespace tactics {

/// A place that nobody knows.
inline constexpr Point kNoPlace{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

/// What two optical sensors at the bottom of the mouse moved since the step before, each in its own axes, mm (counts over counts
/// per mm). Their axes are the mouse's; the second stands on its +x side of the first. A step not later than the one before is a
/// repeat.
struct OpticalStep {
    double time = 0;  ///< s, CLOCK_MONOTONIC where it is a real mouse
    Point first, second;
};

/// Where an absolute overlay saw the finger; it was there some time before it is told.
struct OverlaySample {
    double time = 0;  ///< s, when it came in, by the clock of the steps
    Point at;
};

struct Pose {
    Point at;            ///< of the fingertip; until an overlay has told, from where it began
    double heading = 0;  ///< rad, from +x towards +y
    Point velocity;      ///< mm/s
    double doubt = 0;    ///< mm/s that the velocity may be wrong by
};

struct MouseGeometry {
    double sensors_apart = 60;  ///< mm
    Point finger;               ///< of the fingertip, from the middle between the sensors, mm, heading 0
};

/// Any numbers may come in, in any order: what cannot be is passed over. Nothing allocates after construction.
class Fusion {
public:
    virtual ~Fusion() = default;
    virtual void step(const OpticalStep& step) noexcept = 0;
    virtual void overlay(const OverlaySample& sample) noexcept = 0;
    virtual Pose pose() const noexcept = 0;
    virtual unsigned resets() const noexcept = 0;  ///< how often divergence was noticed and mended
    /// What it has found, for the next time; nothing where it learns nothing, or has seen nothing yet.
    virtual std::optional<LearnedPointing> learned() const noexcept { return std::nullopt; }
};

/// The paper's: the overlay's place plus what the sensors moved in the 0.15 s before it came in.
std::unique_ptr<Fusion> paper_fusion(const MouseGeometry& geometry, double delay = 0.15);
/// Learns delay, scale and heading (and delay as a function of speed), from nothing or from what was learned last time.
std::unique_ptr<Fusion> learning_fusion(const MouseGeometry& geometry, const std::optional<LearnedPointing>& before = {});

}  // namespace tactics
