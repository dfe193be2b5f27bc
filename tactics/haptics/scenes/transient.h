// SPDX-License-Identifier: Apache-2.0
// A short vibration where the finger passes an edge. A lever that only moves up and down cannot turn its force, so edges feel
// blurred; the paper on the 1-DOF haptic mouse asks for "adding vibration" there (section VI).
//
// A decaying sine that grows with the speed of touch is the usual form for contact in haptic rendering (from memory: Okamura,
// Kuchenbecker); the numbers are chosen, not measured.
#pragma once

#include "tactics/drawing.h"

namespace tactics {

struct TransientSettings {
    double force_per_speed = 0.005;  ///< N s/mm: 0.5 N at 100 mm/s
    double most_force = 1;           ///< N
    double frequency_hz = 250;       ///< upper limit; 100 to 300 are felt best
    double decay = 0.008;            ///< s until 1/e
    double bend = 1;                 ///< change of slope, mm up per mm sideways, that makes an edge
};

/// Hz: that of the settings, limited so that a loop of this rate has ten forces per period; 0 below 100 Hz, where it no longer
/// feels like an edge and is not played.
double transient_frequency(const TransientSettings& settings, double rate_hz) noexcept;

class EdgeTransient {
public:
    EdgeTransient(const TransientSettings& settings, double rate_hz)
        : settings_(settings), frequency_(transient_frequency(settings, rate_hz)) {}

    /// N to add at this tick. `height` is that of the surface at `at`. No allocation.
    double force(double height, Point at, double dt) noexcept;

private:
    TransientSettings settings_;
    double frequency_ = 0;
    bool begun_ = false, knows_slope_ = false;
    Point before_;
    double height_before_ = 0, moved_ = 0, elapsed_ = 0, slope_ = 0;
    double amplitude_ = 0, since_ = 0;
};

}  // namespace tactics
