// SPDX-License-Identifier: Apache-2.0
// The spoken words about a plot: the finger's position, what is near it and under it, in the plot's own names and units.
#pragma once

#include <memory>

#include "tactics/haptics/voice/announcement.h"
#include "tactics/haptics/voice/spoken_value.h"
#include "tactics/plot.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The position of the plot under the finger: x to the right, y upwards, z towards it.
struct SpokenFrame {
    AxisSpan x, y, z = {};
};

/// Words without a full stop; names and units as written. A value that is cheap to copy, for any thread.
///
///     position      "time 2.5 s, speed 12 m/s"
///     nearest       "nearest: point 12 of 40 of car, time 2.5 s, speed 12 m/s, 3 mm away to the right", on the paper
///     under finger  "curve car", "point A, time 2 s, speed 8 m/s", "time axis", "time axis, tick 2.5 s",
///                   "grid line speed 10 m/s", "nothing",
///                   "surface, height 3.2 m, gentle slope, rising with x, falling with y", "surface hills, height 3 m, level"
///     curve end     "end of the curve car, time 10 s, speed 3 m/s", or its beginning
///     way end       the same, but where neither is within 1 mm "end of a piece of the curve car", which a gap makes
///     highest       "highest: time 4 s, speed 30 m/s", lowest alike; of several the first
///     comparison    "at time 2.5 s: car 12 m/s, bus 10 m/s, car 2 m/s higher", where each curve is first met at that x
///     maximum       "maximum of car, time 4 s, speed 30 m/s", minimum alike
///     choice        "follow", the name of an action
///
/// Things that the plot lacks are "nothing" or "not known"; an invalid series number is never used.
class PlotWords {
public:
    PlotWords(std::shared_ptr<const Plot> plot, const SpokenFrame& frame) : plot_(std::move(plot)), frame_(frame) {}

    Phrase of(const Announcement& announcement) const;

private:
    Phrase position(double x, double y, double z) const;
    Phrase nearest(double x, double y) const;
    Phrase under_finger(const Announcement& one) const;
    Phrase on_surface(const Announcement& one) const;
    Phrase curve_end(const Announcement& one) const;
    Phrase extreme(const Announcement& one) const;
    Phrase comparison(const Announcement& one) const;
    Phrase turn(const Announcement& one) const;
    Phrase value(const Axis& axis, const AxisSpan& span, double at) const;
    Phrase value_of(const Axis& axis, const AxisSpan& span, const Phrase& otherwise, double at) const;
    const PlotCurve* curve(std::size_t series) const;
    Phrase name_of_curve(std::size_t series) const;

    std::shared_ptr<const Plot> plot_;
    SpokenFrame frame_;
};

/// The value where the curve is first met at x. Lines are straight on the paper, so interpolation is logarithmic on logarithmic
/// axes. NaN if unknown: outside, or in a gap.
double height_of_curve(const Plot& plot, const PlotCurve& curve, double x);

}  // namespace tactics
