// SPDX-License-Identifier: Apache-2.0
// A haptic device and its samples, tick by tick: a mouse, moved over a table, whose lever lifts one finger; or an arm, which
// pushes a fingertip or a stylus in space.
#pragma once

#include "tactics/haptics/sensing/fusion.h"
#include "tactics/point3.h"

namespace tactics {

struct HapticSample {
    double height = 0;  ///< of the fingertip, mm; for a mouse, by its encoder
    OpticalStep moved;  ///< since the previous sample
    bool has_overlay = false;
    OverlaySample overlay;     ///< if it has one
    bool knows_place = false;  ///< it needs no fusion: `place` is the finger's position
    Point place = kNoPlace;    ///< mm; the finger's position, known only to arms and simulated mice
    double place_time = 0;     ///< s, CLOCK_MONOTONIC, arrival of place and height if another thread reported them; or 0
    unsigned words = 0,
             lost = 0;  ///< reports of the mouse since the sample before; and that never came, by their numbers (of 256)
    bool stop_key = false;
    unsigned keys = 0;   ///< that are down: bit 0 the first, as its maker counts them
    bool fault = false;  ///< it switched its motor off: too hot, or without a command for too long
};

class HapticDevice {
public:
    enum class State { fine, nothing, over, gone };
    virtual ~HapticDevice() = default;
    /// Its measurements up to now; nothing: no report since the last. `dt` has passed since the last call.
    virtual State read(HapticSample& sample, double dt) noexcept = 0;
    /// N; a mouse applies the upward part. false: gone.
    virtual bool push(const Point3& force) noexcept = 0;
    /// The play is over: its motor may be switched off.
    virtual void let_go() noexcept {}
    /// After it was gone: whether it is back; `why` if it is back but may not be used. May take a moment.
    virtual bool reopen(std::string& /*why*/) { return false; }
    /// Whether it runs in real time; others run as fast as the processor allows.
    virtual bool is_real() const { return false; }
};

}  // namespace tactics
