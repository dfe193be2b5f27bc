// SPDX-License-Identifier: Apache-2.0
// A short swing of force where the finger passes an edge. A lever that only goes up and down cannot turn its force, so edges feel
// blurred; the paper on the 1-DOF haptic mouse asks for "adding vibration" there (section VI).
//
// The form, a decaying sine that grows with the speed of the touch, is the usual one for contact in haptic rendering (from
// memory: Okamura, Kuchenbecker); the numbers are chosen, not measured.
#pragma once

#include "tactics/drawing.h"

namespace tactics {

struct TransientSettings {
    double force_per_speed = 0.005;  ///< N s/mm: 0.5 N at 100 mm/s
    double most_force = 1;           ///< N
    double frequency_hz = 250;       ///< at most; 100 to 300 are felt best
    double decay = 0.008;            ///< s until 1/e
    double bend = 1;                 ///< mm up for a mm sideways by which the slope must change to be an edge
};

/// Hz: that of the settings, or as much as a loop of this rate has ten forces a swing for; 0 below 100 Hz, where it is no longer
/// felt as an edge: then nothing is played.
double transient_frequency(const TransientSettings& settings, double rate_hz) noexcept;

class EdgeTransient {
public:
    EdgeTransient(const TransientSettings& settings, double rate_hz)
        : settings_(settings), frequency_(transient_frequency(settings, rate_hz)) {}

    /// N to be added at this tick. `height` of the surface at `at`. No allocation.
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
