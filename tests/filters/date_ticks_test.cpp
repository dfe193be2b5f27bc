// SPDX-License-Identifier: Apache-2.0
// Ticks of dates, against a calendar that counts day by day.
#include "filters/date_ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace tactics::date_ticks_test {
namespace {

// Seconds of "2024", "2024-03", "2024-03-05" by counting days from 1970 on.
double counted(const std::string& text) {
    const int year = std::stoi(text.substr(0, 4)), month = text.size() > 4 ? std::stoi(text.substr(5, 2)) : 1,
              day = text.size() > 7 ? std::stoi(text.substr(8, 2)) : 1;
    const auto leap = [](int y) { return y % 4 == 0 && (y % 100 != 0 || y % 400 == 0); };
    double days = day - 1;
    for (int y = 1970; y < year; ++y) days += leap(y) ? 366 : 365;
    for (int y = year; y < 1970; ++y) days -= leap(y) ? 366 : 365;
    constexpr int kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    for (int m = 1; m < month; ++m) days += kDays[m - 1] + (m == 2 && leap(year) ? 1 : 0);
    return days * 86400;
}

TEST(DateTicks, SayWhereTheyStand) {
    std::mt19937 random(8);
    for (int round = 0; round < 3000; ++round) {
        const double low = (static_cast<double>(random() % 4'000'000) - 1'500'000) * 1000 + static_cast<double>(random() % 1000);
        const double high = low + std::pow(10.0, static_cast<double>(random() % 100) / 10) + 1;
        const int most = 3 + static_cast<int>(random() % 6);
        const DateTicks dates = date_ticks(low, high, most);
        const auto& at = dates.ticks.at;
        ASSERT_GE(at.size(), 2u) << low << " " << high;
        ASSERT_LE(at.size(), static_cast<std::size_t>(most));
        ASSERT_EQ(dates.words.size(), at.size());
        EXPECT_LE(dates.ticks.low, low);
        EXPECT_GE(dates.ticks.high, high);
        for (std::size_t i = 0; i < at.size(); ++i) {
            if (i > 0) {
                EXPECT_GT(at[i], at[i - 1]);
            }
            EXPECT_GE(at[i], dates.ticks.low);
            EXPECT_LE(at[i], dates.ticks.high);
            const std::string& word = dates.words[i];
            if (dates.since.empty()) {
                EXPECT_EQ(counted(word), at[i]) << word;
            } else {
                const double in_day = std::stoi(word.substr(0, 2)) * 3600 + std::stoi(word.substr(3, 2)) * 60 +
                                      (word.size() > 5 ? std::stoi(word.substr(6, 2)) : 0);
                EXPECT_EQ(std::fmod(at[i] - counted(dates.since), 86400), in_day) << word << " since " << dates.since;
            }
        }
    }
}

TEST(DateTicks, AreThoseThatAPersonWouldTake) {
    const auto words = [](const char* from, const char* to) { return date_ticks(counted(from), counted(to), 6).words; };
    EXPECT_EQ(words("2000", "2020"), (std::vector<std::string>{"2000", "2005", "2010", "2015", "2020"}));
    EXPECT_EQ(words("2024-01", "2024-06"),
              (std::vector<std::string>{"2024-01", "2024-02", "2024-03", "2024-04", "2024-05", "2024-06"}));
    EXPECT_EQ(words("2024-02-27", "2024-03-02").front(), "2024-02-27");
    EXPECT_EQ(date_text(counted("2024-02-29") + 3661), "2024-02-29 01:01:01");
    EXPECT_EQ(date_text(counted("1969-12-31")), "1969-12-31");
}

}  // namespace
}  // namespace tactics::date_ticks_test
