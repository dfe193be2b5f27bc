// SPDX-License-Identifier: Apache-2.0
// Numbers and dates for a synthesiser: no more digits than the plot supports, and no garbled exponents.
#pragma once

#include <string>

#include "tactics/text/phrase.h"

namespace tactics {

/// The visible range of one axis of a plot.
struct AxisSpan {
    double from = 0, to = 1;  ///< its two ends, in plot coordinates, in either order
    double mm = 100;          ///< its length under a finger
    double resolution = 0;    ///< mm, of the device that gives the position; 0: finer than any spoken value
};

/// The smallest useful difference of values near `value`: a 500th of the axis, which over 160 mm is a third of a millimetre,
/// finer than a hand can return to; or the device's resolution, if that is coarser. On a logarithmic axis it is this share of the
/// ratio.
double telling_step(const AxisSpan& span, bool logarithmic, double value);

/// The value rounded to the power of ten at or below `step`, so at most half a step away: "2.5", "-0.04", "347000". A minus is a
/// hyphen, which espeak-ng 1.51 speaks as "minus" at the beginning and within a line. It speaks 1.2e-9 as "one point two e nine",
/// so numbers that need more than six decimals or 15 digits before the point are written "1.2 times 10 to the minus 9", with a
/// power that is a multiple of three and fits `largest`, the largest value of the axis.
Phrase spoken_number(double value, double step, double largest);

/// Seconds since 1970-01-01 00:00 UTC as a date, with as much of the time as that step in seconds supports: "2024-02-29",
/// "2024-02-29 13:05", "2024-02-29 13:05:07", "2024-02-29 13:05:07.25". Rounded down, as clocks do.
Phrase spoken_date(double seconds, double step);

}  // namespace tactics
