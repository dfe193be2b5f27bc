// SPDX-License-Identifier: Apache-2.0
// A hand that moves the mouse over a table, and what two optical sensors and an overlay tell of it, with what goes wrong by name.
// The bench on which fusions are compared; nothing of it is known to them.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/haptics/sensing/fusion.h"

namespace tactics {

/// From rest to rest along a line: speeding up as a minimum-jerk movement does (T. Flash, N. Hogan 1985), steady, slowing down
/// evenly.
struct PointingStroke {
    double begin = 0;  ///< s
    Point from, to;
    double speed = 100;          ///< mm/s, while steady
    double deceleration = 2500;  ///< mm/s2
};

/// Strokes one after the other, with rests between them.
class Pointing {
public:
    /// `sway`: how far the mouse turns in the hand meanwhile, to either side, rad.
    Pointing(std::vector<PointingStroke> strokes, double heading, double sway);

    Pose at(double time) const;  ///< the truth
    const std::vector<PointingStroke>& strokes() const { return strokes_; }
    double stop(std::size_t stroke) const;  ///< s, when it has come to rest
    double end() const;                     ///< s, of the rest after the last

private:
    std::vector<PointingStroke> strokes_;
    double heading_, sway_;
};

/// Of one length and speed, in directions by chance, so that they stay on a table of 600 x 400 mm.
Pointing straight_strokes(int count, double speed, double deceleration, std::uint64_t seed, double heading = 0, double sway = 0);
/// 40 to 400 mm/s, 40 to 300 mm long, decelerations of 2.5 to 10 m/s2, rests of 0.1 to 0.5 s.
Pointing random_strokes(int count, std::uint64_t seed, double heading = 0, double sway = 0);

/// From one place to the other and back, with rests, until `seconds` are over. Slower where the way is too short for the speed.
Pointing to_and_fro(Point from, Point to, double speed, double seconds);

/// What is wrong with what is told; nothing, unless set.
struct PointingCauses {
    double scale = 1;          ///< of both sensors: 1.04 counts 104 mm on a way of 100
    double second_scale = 1;   ///< of the second besides
    double acceleration = 1;   ///< so many times more is counted at 250 mm/s: 1 up to 100 mm/s, from there a straight line
    double heading_drift = 0;  ///< rad per mm of the way
    double counts_per_mm = 0;  ///< of the sensors; 0: they do not round
    double delay = 0.15;       ///< s, of the overlay
    double jitter = 0;         ///< s, standard deviation of its delay, from sample to sample
    double noise = 0;          ///< mm, standard deviation of its place, each way
    double quicker =
        0;  ///< s: so much sooner at 250 mm/s and more; the delay is whole up to 100 mm/s, and a straight line between
    double smoothing =
        0;              ///< s: the overlay's places pass a one euro filter of that time constant at rest, half of it at 100 mm/s
    double judged = 0;  ///< when the speed of `quicker` was: 0: when the sample is told, 1: when the finger was there
};

/// Scale, another delay than 0.15 s, jitter, noise, pointer acceleration and a drifting heading, all at once.
PointingCauses all_causes();

struct Sensed {
    std::vector<OpticalStep> steps;
    std::vector<OverlaySample> samples;
};

/// Steps at `rate`, samples at 60 Hz, in the order of time each.
Sensed sense(const Pointing& pointing, const MouseGeometry& geometry, const PointingCauses& causes, std::uint64_t seed,
             double rate = 1000);

struct PointingError {
    double overshoot = 0;  ///< mm beyond the place of the stop, along the stroke, from 0.2 s before it to the end of the rest:
                           ///< median of the strokes
    double worst_overshoot = 0;  ///< mm
    double rms = 0;              ///< mm, in motion
    double most_of_it = 0;       ///< mm, not exceeded 95 % of the time in motion
    unsigned resets = 0;
};

/// Tells it all to the fusion in the order of time; `each` is called with the time after every step.
template <class Each>
void tell(Fusion& fusion, const Sensed& sensed, Each each) {
    auto sample = sensed.samples.begin();
    for (const OpticalStep& step : sensed.steps) {
        for (; sample != sensed.samples.end() && sample->time <= step.time; ++sample) fusion.overlay(*sample);
        fusion.step(step);
        each(step.time);
    }
}

/// Tells it all to the fusion. The first `learning` strokes do not count.
PointingError pointing_error(Fusion& fusion, const Pointing& pointing, const Sensed& sensed, std::size_t learning = 0);

}  // namespace tactics
