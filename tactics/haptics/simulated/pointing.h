// SPDX-License-Identifier: Apache-2.0
// A hand that moves the mouse over a table, and the readings of two optical sensors and an overlay, with named errors. It is the
// benchmark for fusions, which know nothing of it.
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

/// Successive strokes with rests between them.
class Pointing {
public:
    /// `sway`: how far the mouse turns in the hand to either side, rad.
    Pointing(std::vector<PointingStroke> strokes, double heading, double sway);

    Pose at(double time) const;  ///< the truth
    const std::vector<PointingStroke>& strokes() const { return strokes_; }
    double stop(std::size_t stroke) const;  ///< s, time of coming to rest
    double end() const;                     ///< s, end of the rest after the last stroke

private:
    std::vector<PointingStroke> strokes_;
    double heading_, sway_;
};

/// Strokes of one length and speed, in random directions that stay on a table of 600 x 400 mm.
Pointing straight_strokes(int count, double speed, double deceleration, std::uint64_t seed, double heading = 0, double sway = 0);
/// 40 to 400 mm/s, 40 to 300 mm long, decelerations of 2.5 to 10 m/s2, rests of 0.1 to 0.5 s.
Pointing random_strokes(int count, std::uint64_t seed, double heading = 0, double sway = 0);

/// Between two places and back, with rests, until `seconds` are over. Slower if the distance is too short for the speed.
Pointing to_and_fro(Point from, Point to, double speed, double seconds);

/// Errors of the readings; none by default.
struct PointingCauses {
    double scale = 1;          ///< of both sensors: 1.04 counts 104 mm for 100
    double second_scale = 1;   ///< additional, of the second
    double acceleration = 1;   ///< factor of the counts at 250 mm/s: 1 up to 100 mm/s, linear from there
    double heading_drift = 0;  ///< rad per mm of movement
    double counts_per_mm = 0;  ///< of the sensors; 0: no rounding
    double delay = 0.15;       ///< s, of the overlay
    double jitter = 0;         ///< s, standard deviation of its delay, from sample to sample
    double noise = 0;          ///< mm, standard deviation of its place, in each direction
    double quicker = 0;        ///< s: reduction of the delay at 250 mm/s and above; none up to 100 mm/s, linear in between
    double smoothing = 0;      ///< s: time constant of a one euro filter on the overlay's places at rest; half of it at 100 mm/s
    double judged = 0;  ///< time at which `quicker` takes the speed: 0: arrival of the sample, 1: when the finger was there
};

/// Scale, another delay than 0.15 s, jitter, noise, pointer acceleration and a drifting heading, all at once.
PointingCauses all_causes();

struct Sensed {
    std::vector<OpticalStep> steps;
    std::vector<OverlaySample> samples;
};

/// Steps at `rate`, samples at 60 Hz, each in order of time.
Sensed sense(const Pointing& pointing, const MouseGeometry& geometry, const PointingCauses& causes, std::uint64_t seed,
             double rate = 1000);

struct PointingError {
    double overshoot = 0;  ///< mm beyond the stop, along the stroke, from 0.2 s before it to the end of the rest: median over
                           ///< strokes
    double worst_overshoot = 0;  ///< mm
    double rms = 0;              ///< mm, in motion
    double most_of_it = 0;       ///< mm, not exceeded 95 % of the time in motion
    unsigned resets = 0;
};

/// Feeds everything to the fusion in order of time; calls `each` with the time after every step.
template <class Each>
void tell(Fusion& fusion, const Sensed& sensed, Each each) {
    auto sample = sensed.samples.begin();
    for (const OpticalStep& step : sensed.steps) {
        for (; sample != sensed.samples.end() && sample->time <= step.time; ++sample) fusion.overlay(*sample);
        fusion.step(step);
        each(step.time);
    }
}

/// Feeds everything to the fusion. The first `learning` strokes do not count.
PointingError pointing_error(Fusion& fusion, const Pointing& pointing, const Sensed& sensed, std::size_t learning = 0);

}  // namespace tactics
