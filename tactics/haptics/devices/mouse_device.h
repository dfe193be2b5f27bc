// SPDX-License-Identifier: Apache-2.0
// A haptic mouse: a lever that lifts one finger, on something that is moved over a table. And what it tells, tick by tick.
#pragma once

#include "tactics/haptics/sensing/fusion.h"

namespace tactics {

struct MouseSample {
    double height = 0;  ///< of the fingertip, by the encoder, mm
    OpticalStep moved;  ///< since the sample before
    bool has_overlay = false;
    OverlaySample overlay;     ///< if it has one
    bool knows_place = false;  ///< it needs no fusion: `place` is where the finger is
    Point place = kNowhere;    ///< mm; where the finger truly is, known of simulated mice only
    unsigned words = 0,
             lost = 0;  ///< reports of the mouse since the sample before; and that never came, by their numbers (of 256)
    bool stop_key = false;
    bool fault = false;  ///< its motor is off by itself: too hot, or it had no word for too long
};

class MouseDevice {
public:
    enum class State { fine, nothing, over, gone };
    virtual ~MouseDevice() = default;
    /// What it measured up to now; nothing: no word since the last. `dt` has passed since the last call.
    virtual State read(MouseSample& sample, double dt) noexcept = 0;
    /// N, upwards. false: gone.
    virtual bool push(double force) noexcept = 0;
    /// All has been played: its motor may be switched off.
    virtual void let_go() noexcept {}
    /// After it was gone: whether it is there again; if it is, and may not be used, `why`. May take a moment.
    virtual bool reopen(std::string& /*why*/) { return false; }
    /// Whether it moves by the clock on the wall; the others are as quick as the processor.
    virtual bool is_real() const { return false; }
};

}  // namespace tactics
