// SPDX-License-Identifier: Apache-2.0
// A haptic device: a mouse, whose lever lifts one finger, on something that is moved over a table; or an arm, which pushes a
// fingertip or a stylus in space. And what it tells, tick by tick.
#pragma once

#include "tactics/haptics/sensing/fusion.h"
#include "tactics/point3.h"

namespace tactics {

struct HapticSample {
    double height = 0;  ///< of the fingertip, mm; of a mouse by its encoder
    OpticalStep moved;  ///< since the sample before
    bool has_overlay = false;
    OverlaySample overlay;     ///< if it has one
    bool knows_place = false;  ///< it needs no fusion: `place` is where the finger is
    Point place = kNoPlace;    ///< mm; where the finger is, which a mouse knows only if it is simulated
    double place_time = 0;     ///< s, CLOCK_MONOTONIC, when that and the height came in, where somebody else told them; or 0
    unsigned words = 0,
             lost = 0;  ///< reports of the mouse since the sample before; and that never came, by their numbers (of 256)
    bool stop_key = false;
    unsigned keys = 0;   ///< that are down: bit 0 the first, as its maker counts them
    bool fault = false;  ///< its motor is off by itself: too hot, or it had no word for too long
};

class HapticDevice {
public:
    enum class State { fine, nothing, over, gone };
    virtual ~HapticDevice() = default;
    /// What it measured up to now; nothing: no word since the last. `dt` has passed since the last call.
    virtual State read(HapticSample& sample, double dt) noexcept = 0;
    /// N; a mouse gives what goes upwards. false: gone.
    virtual bool push(const Point3& force) noexcept = 0;
    /// All has been played: its motor may be switched off.
    virtual void let_go() noexcept {}
    /// After it was gone: whether it is there again; if it is, and may not be used, `why`. May take a moment.
    virtual bool reopen(std::string& /*why*/) { return false; }
    /// Whether it moves by the clock on the wall; the others are as quick as the processor.
    virtual bool is_real() const { return false; }
};

}  // namespace tactics
