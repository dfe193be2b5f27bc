// SPDX-License-Identifier: Apache-2.0
// Ticks along an axis of dates.
#pragma once

#include <string>
#include <vector>

#include "filters/ticks.h"

namespace tactics {

/// Ticks in ISO 8601 notation, shortened to the parts that differ: 2024, 2024-03, 2024-03-05, 06:30, 06:30:15.
struct DateTicks {
    Ticks ticks;
    std::vector<std::string> words;  ///< of each
    std::string since;               ///< the day to which times of day belong, 2024-03-05; empty: the words tell it
};

/// Seconds since 1970-01-01 00:00 UTC (of the years 1 to 9999; beyond, the ticks are plain numbers of years) in at most `most`
/// (>= 3) steps of 1, 2 or 5 years times a power of ten, of 1, 3 or 6 months, of 1, 2, 7 or 14 days, or, within a day and a half,
/// of hours, minutes and seconds.
DateTicks date_ticks(double low, double high, int most);

/// The days at both ends of such a span, for an axis whose steps have no room for their words; of a span with times of day the
/// outer ones of few ticks.
DateTicks date_ends(double low, double high);

/// One value as such a date, to the second; without the time of day where that is 00:00.
std::string date_text(double seconds);

}  // namespace tactics
