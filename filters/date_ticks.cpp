// SPDX-License-Identifier: Apache-2.0
#include "filters/date_ticks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

namespace tactics {

namespace {

using std::chrono::day;
using std::chrono::month;
using std::chrono::sys_days;
using std::chrono::year;
using std::chrono::year_month_day;

constexpr double kDay = 86400;
constexpr double kFirstDate = -62135596800.0, kLastDate = 253402300799.0;  // 0001-01-01 00:00:00, 9999-12-31 23:59:59
constexpr double kMostTimes = 1.5 * kDay;                                  // longer spans have no times of day

std::string padded(long long number, int digits) {
    std::string text = std::to_string(number);
    while (static_cast<int>(text.size()) < digits) text.insert(text.begin(), '0');
    return text;
}

year_month_day day_of(double seconds) {
    return year_month_day(sys_days(std::chrono::days(static_cast<int>(std::floor(seconds / kDay)))));
}

double seconds_of(long long years, long long months) {  // months from 0 on, over 11 in the years behind
    const long long whole = years * 12 + months;
    const long long y = whole >= 0 ? whole / 12 : -((11 - whole) / 12), m = whole - y * 12;
    const sys_days first(year_month_day(year(static_cast<int>(y)), month(static_cast<unsigned>(m + 1)), day(1)));
    return static_cast<double>(first.time_since_epoch().count()) * kDay;
}

std::string year_text(const year_month_day& date) { return padded(int{date.year()}, 4); }
std::string month_text(const year_month_day& date) { return year_text(date) + "-" + padded(unsigned{date.month()}, 2); }
std::string day_text(const year_month_day& date) { return month_text(date) + "-" + padded(unsigned{date.day()}, 2); }

std::string time_text(double seconds, bool to_second) {
    const auto in_day = static_cast<long long>(std::floor(seconds - std::floor(seconds / kDay) * kDay));
    const std::string text = padded(in_day / 3600, 2) + ":" + padded(in_day / 60 % 60, 2);
    return to_second ? text + ":" + padded(in_day % 60, 2) : text;
}

// All multiples of a step of seconds within.
std::vector<double> multiples(double low, double high, double step, int most) {
    std::vector<double> ticks;
    for (double at = std::ceil(low / step) * step; at <= high && static_cast<int>(ticks.size()) <= most; at += step)
        ticks.push_back(at);
    return ticks;
}

std::vector<double> months(double low, double high, long long step, int most) {
    std::vector<double> ticks;
    const year_month_day date = day_of(low);
    const long long first = int{date.year()} * 12LL + static_cast<long long>(unsigned{date.month()}) - 1;
    for (long long at = first / step * step; static_cast<int>(ticks.size()) <= most; at += step) {
        const double seconds = seconds_of(0, at);
        if (seconds > high) break;
        if (seconds >= low) ticks.push_back(seconds);
    }
    return ticks;
}

using Text = std::string (*)(const year_month_day&);

DateTicks with_words(double low, double high, std::vector<double> at, Text text) {
    DateTicks dates{{low, high, std::move(at)}, {}, {}};
    for (const double tick : dates.ticks.at) dates.words.push_back(text(day_of(tick)));
    return dates;
}

DateTicks whole_days(double low, double high) {
    low = std::floor(low / kDay) * kDay;
    high = std::max(low + kDay, std::ceil(high / kDay) * kDay);
    return with_words(low, high, {low, high}, day_text);
}

bool fit(const std::vector<double>& ticks, int most) {
    return ticks.size() >= 2 && ticks.size() <= static_cast<std::size_t>(most);
}

}  // namespace

std::string date_text(double seconds) {
    if (!(seconds >= kFirstDate && seconds <= kLastDate)) return std::to_string(std::llround(seconds / kDay / 365.2425 + 1970));
    const std::string text = day_text(day_of(seconds));
    const double in_day = seconds - std::floor(seconds / kDay) * kDay;
    if (in_day < 1) return text;
    return text + " " + time_text(seconds, std::fmod(std::floor(in_day), 60) != 0);
}

DateTicks date_ticks(double low, double high, int most) {
    if (!(high - low >= 1)) {  // one moment: a day around it
        low = std::floor(low / kDay) * kDay;
        high = low + kDay;
    }
    if (!(low >= kFirstDate && high <= kLastDate)) {
        DateTicks dates{ticks_for(low, high, false, most), {}, {}};
        for (const double tick : dates.ticks.at) dates.words.push_back(date_text(tick));
        return dates;
    }
    if (high - low <= kMostTimes)
        for (const double step : {1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200})
            if (std::vector<double> ticks = multiples(low, high, step, most); fit(ticks, most)) {
                DateTicks dates{{low, high, std::move(ticks)}, {}, day_text(day_of(low))};
                for (const double tick : dates.ticks.at) dates.words.push_back(time_text(tick, step < 60));
                return dates;
            }
    for (const double days : {1, 2, 7, 14})
        if (auto ticks = multiples(low, high, days * kDay, most); fit(ticks, most))
            return with_words(low, high, std::move(ticks), day_text);
    for (const long long step : {1, 3, 6})
        if (auto ticks = months(low, high, step, most); fit(ticks, most))
            return with_words(low, high, std::move(ticks), month_text);
    for (long long power = 1; power <= 1000; power *= 10)
        for (const long long digit : {1, 2, 5})
            if (auto ticks = months(low, high, 12 * digit * power, most); fit(ticks, most))
                return with_words(low, high, std::move(ticks), year_text);
    return whole_days(low, high);  // of no step two lie within
}

DateTicks date_ends(double low, double high) {
    if (low >= kFirstDate && high <= kLastDate && high - low > kMostTimes) return whole_days(low, high);
    DateTicks ends = date_ticks(low, high, 3);
    ends.ticks.at = {ends.ticks.at.front(), ends.ticks.at.back()};
    ends.words = {ends.words.front(), ends.words.back()};
    return ends;
}

}  // namespace tactics
