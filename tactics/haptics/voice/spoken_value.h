// SPDX-License-Identifier: Apache-2.0
// Numbers and dates as a synthesiser should get them: no more digits than a plot can mean, no exponent that is garbled.
#pragma once

#include <string>

namespace tactics {

/// What a plot shows of one axis.
struct AxisSpan {
    double from = 0, to = 1;  ///< at its two ends, in plot coordinates; which is larger does not matter
    double mm = 100;          ///< how long it is, to a finger
    double resolution = 0;    ///< mm, of the device that knows the place; 0: finer than anything said here
};

/// The step between two values that are worth telling apart at `value`: a 500th of the axis, which over 160 mm is a third of a
/// millimetre, less than a hand comes back to; or the device's resolution, if that is coarser. On a logarithmic axis it is that
/// share of a step in ratio.
double telling_step(const AxisSpan& span, bool logarithmic, double value);

/// The value rounded to the power of ten at or below `step`, so at most half a step away: "2.5", "-0.04", "347000". A minus is a
/// hyphen, which espeak-ng 1.51 speaks as "minus" at the beginning and within a line. It speaks 1.2e-9 as "one point two e nine",
/// so where more than six decimals or 15 digits before the point would be needed it is "1.2 times 10 to the minus 9", with a
/// power that is a multiple of three and belongs to `largest`, the largest value of its axis.
std::string spoken_number(double value, double step, double largest);

/// Seconds since 1970-01-01 00:00 UTC as a date, and as much of the time as a step of so many seconds leaves: "2024-02-29",
/// "2024-02-29 13:05", "2024-02-29 13:05:07", "2024-02-29 13:05:07.25". What has begun counts, as with clocks.
std::string spoken_date(double seconds, double step);

}  // namespace tactics
