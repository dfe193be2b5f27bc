// SPDX-License-Identifier: Apache-2.0
// Dates and times as text, without the locale: seconds since 1970-01-01 00:00 UTC.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace tactics {

/// The order of the parts of a date. Four digits at the beginning are the year in any order.
enum class DateOrder : std::uint8_t { year_first, day_first, month_first };

enum class DateFault : std::uint8_t {
    none,
    other,       ///< no date in that order
    impossible,  ///< 31 April, 29 February of a common year, 25:00
    old,         ///< before 15 October 1582, when the Gregorian calendar began
};

struct DateReading {
    double seconds = 0;
    DateFault fault = DateFault::none;
};

/// 2024-02-29, 2024/02/29, 2024-02, 2024-Q1, and 29.2.2024, 29/2/2024 or 29-2-2024 in an order that has the year last; then,
/// after a T or a blank, 13:05, 13:05:07 or 13:05:07.25, and Z or an offset, +02:00 (ISO 8601-1:2019). The default is UTC. A
/// month and a quarter mean their first day. 23:59:60 is the following second, as in POSIX.
DateReading read_date(std::string_view text, DateOrder order);

/// The first two numbers of a possible date with its year last: 29.2.2024, 2/29/2024.
struct DayAndMonth {
    int first = 0, second = 0;
};
std::optional<DayAndMonth> day_and_month(std::string_view text);

/// Days from 1970-01-01 in the Gregorian calendar, also before it began. Month 1 to 12.
long long days_from_1970(int year, int month, int day);

}  // namespace tactics
