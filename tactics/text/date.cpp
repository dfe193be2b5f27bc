// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/date.h"

#include <array>
#include <charconv>

namespace tactics {

namespace {

constexpr double kSecondsADay = 86'400;

// Takes digits, at least `least` and at most `most` of them.
std::optional<int> take_digits(std::string_view& text, std::size_t least, std::size_t most) {
    std::size_t count = 0;
    int value = 0;
    while (count < text.size() && count <= most && text[count] >= '0' && text[count] <= '9')
        value = value * 10 + (text[count++] - '0');
    if (count < least || count > most) return std::nullopt;
    text.remove_prefix(count);
    return value;
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
}

bool is_leap(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

int days_of(int year, int month) {
    constexpr std::array<int, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return month == 2 && is_leap(year) ? 29 : kDays[static_cast<std::size_t>(month - 1)];
}

struct Day {
    int year = 0, month = 1, day = 1;
};

// Takes the date before a time.
std::optional<Day> take_day(std::string_view& text, DateOrder order) {
    std::string_view rest = text;
    Day day;
    if (const auto year = take_digits(rest, 4, 4)) {
        day.year = *year;
        if (rest.starts_with("-Q") || rest.starts_with("Q")) {
            rest.remove_prefix(rest.front() == '-' ? 2 : 1);
            const auto quarter = take_digits(rest, 1, 1);
            if (!quarter || *quarter < 1 || *quarter > 4 || !rest.empty()) return std::nullopt;
            day.month = 3 * *quarter - 2;
            text = rest;
            return day;
        }
        if (rest.empty() || (rest.front() != '-' && rest.front() != '/')) return std::nullopt;
        const char mark = rest.front();
        rest.remove_prefix(1);
        const auto month = take_digits(rest, 2, 2);
        if (!month) return std::nullopt;
        day.month = *month;
        if (take(rest, mark)) {
            const auto number = take_digits(rest, 2, 2);
            if (!number) return std::nullopt;
            day.day = *number;
        } else if (!rest.empty() || mark != '-') {
            return std::nullopt;  // a month alone has no time
        }
        text = rest;
        return day;
    }
    if (order == DateOrder::year_first) return std::nullopt;
    const auto first = take_digits(rest, 1, 2);
    if (!first || rest.empty() || (rest.front() != '.' && rest.front() != '/' && rest.front() != '-')) return std::nullopt;
    const char mark = rest.front();
    rest.remove_prefix(1);
    const auto second = take_digits(rest, 1, 2);
    if (!second || !take(rest, mark)) return std::nullopt;
    const auto year = take_digits(rest, 4, 4);
    if (!year) return std::nullopt;
    text = rest;
    return order == DateOrder::day_first ? Day{*year, *second, *first} : Day{*year, *first, *second};
}

// Seconds into the day, minus the offset from UTC; nothing if it is no time. `possible` is false for 25:00.
std::optional<double> take_time(std::string_view& text, bool& possible) {
    const auto hour = take_digits(text, 2, 2);
    if (!hour || !take(text, ':')) return std::nullopt;
    const auto minute = take_digits(text, 2, 2);
    if (!minute) return std::nullopt;
    int second = 0;
    double fraction = 0;
    if (take(text, ':')) {
        const auto whole = take_digits(text, 2, 2);
        if (!whole) return std::nullopt;
        second = *whole;
        if (!text.empty() && (text.front() == '.' || text.front() == ',')) {
            std::size_t digits = 1;
            while (digits < text.size() && text[digits] >= '0' && text[digits] <= '9') ++digits;
            if (digits == 1) return std::nullopt;
            double scale = 0.1;
            std::array<char, 20> written{'0', '.'};
            std::size_t length = 2;
            for (std::size_t i = 1; i < digits && length < written.size(); ++i) written[length++] = text[i];
            std::from_chars(written.data(), written.data() + length, scale);
            fraction = scale;
            text.remove_prefix(digits);
        }
    }
    const bool leap = second == 60 && *minute == 59;
    possible = possible && *hour <= 23 && *minute <= 59 && (second <= 59 || leap);
    double ahead = 0;
    if (!take(text, 'Z') && !text.empty() && (text.front() == '+' || text.front() == '-')) {
        const double sign = text.front() == '-' ? -1 : 1;
        text.remove_prefix(1);
        std::string_view two = text.substr(0, 2);
        const auto hours = take_digits(two, 2, 2);
        if (!hours) return std::nullopt;
        text.remove_prefix(2);
        int minutes = 0;
        if (!text.empty()) {
            take(text, ':');
            const auto more = take_digits(text, 2, 2);
            if (!more) return std::nullopt;
            minutes = *more;
        }
        possible = possible && *hours <= 23 && minutes <= 59;
        ahead = sign * (*hours * 3600 + minutes * 60);
    }
    return *hour * 3600 + *minute * 60 + second + fraction - ahead;
}

}  // namespace

// The year begins in March, so that a leap day is its last: 153 days in each five months from there, 146,097 in each 400 years
// (H. Hinnant, "chrono-Compatible Low-Level Date Algorithms", 2013, days_from_civil).
long long days_from_1970(int year, int month, int day) {
    const long long y = month <= 2 ? year - 1LL : year;
    const long long era = (y >= 0 ? y : y - 399) / 400, of_era = y - era * 400;
    const long long of_year = (153 * (month > 2 ? month - 3 : month + 9) + 2) / 5 + day - 1;
    return era * 146'097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719'468;
}

DateReading read_date(std::string_view text, DateOrder order) {
    const auto day = take_day(text, order);
    if (!day) return {0, DateFault::other};
    bool possible = day->month >= 1 && day->month <= 12 && day->day >= 1 && day->day <= days_of(day->year, day->month);
    double time = 0;
    if (!text.empty()) {
        if (text.front() != 'T' && text.front() != ' ') return {0, DateFault::other};
        text.remove_prefix(1);
        const auto seconds = take_time(text, possible);
        if (!seconds || !text.empty()) return {0, DateFault::other};
        time = *seconds;
    }
    if (!possible) return {0, DateFault::impossible};
    const long long days = days_from_1970(day->year, day->month, day->day);
    if (days < days_from_1970(1582, 10, 15)) return {0, DateFault::old};
    return {static_cast<double>(days) * kSecondsADay + time, DateFault::none};
}

std::optional<DayAndMonth> day_and_month(std::string_view text) {
    const std::string_view whole = text;
    const auto day = take_day(text, DateOrder::day_first);
    if (!day || read_date(whole, DateOrder::year_first).fault != DateFault::other ||
        read_date(whole, DateOrder::day_first).fault == DateFault::other)
        return std::nullopt;
    return DayAndMonth{day->day, day->month};
}

}  // namespace tactics
