// SPDX-License-Identifier: Apache-2.0
// Estimates the finger's position from a late absolute overlay and two optical sensors that measure only movement (1-DOF haptic
// mouse, V.A).
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "tactics/drawing.h"
#include "tactics/haptics/sensing/learned.h"

namespace tactics {

/// An unknown place.
inline constexpr Point kNoPlace{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

/// Movement of two optical sensors at the bottom of the mouse since the previous step, each in its own axes, mm (counts over
/// counts per mm). Their axes are the mouse's; the second stands on its +x side of the first. A step not later than the one
/// before is a repeat.
struct OpticalStep {
    double time = 0;  ///< s, CLOCK_MONOTONIC for a real mouse
    Point first, second;
};

/// The place where an absolute overlay saw the finger, some time before the sample arrives.
struct OverlaySample {
    double time = 0;  ///< s, time of arrival, by the clock of the steps
    Point at;
};

struct Pose {
    Point at;            ///< of the fingertip; relative to its start until an overlay sample arrives
    double heading = 0;  ///< rad, from +x towards +y
    Point velocity;      ///< mm/s
    double doubt = 0;    ///< possible error of the velocity, mm/s
};

struct MouseGeometry {
    double sensors_apart = 60;  ///< mm
    Point finger;               ///< the fingertip, from the middle between the sensors, mm, at heading 0
};

/// Accepts any numbers in any order and ignores impossible ones. Nothing allocates after construction.
class Fusion {
public:
    virtual ~Fusion() = default;
    virtual void step(const OpticalStep& step) noexcept = 0;
    virtual void overlay(const OverlaySample& sample) noexcept = 0;
    virtual Pose pose() const noexcept = 0;
    virtual unsigned resets() const noexcept = 0;  ///< how often it detected and corrected divergence
    /// The learned parameters, for the next use; nothing if it learns nothing, or has seen nothing yet.
    virtual std::optional<LearnedPointing> learned() const noexcept { return std::nullopt; }
};

/// The paper's method: the overlay's place plus the sensors' movement in the 0.15 s before its arrival.
std::unique_ptr<Fusion> paper_fusion(const MouseGeometry& geometry, double delay = 0.15);
/// Learns delay, scale and heading (and delay as a function of speed), from scratch or from the parameters learned last time.
std::unique_ptr<Fusion> learning_fusion(const MouseGeometry& geometry, const std::optional<LearnedPointing>& before = {});

}  // namespace tactics
