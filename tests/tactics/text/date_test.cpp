// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/date.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/tool.h"

namespace tactics::date_test {
namespace {

using namespace tests;

double seconds(std::string_view text, DateOrder order = DateOrder::year_first) {
    const DateReading date = read_date(text, order);
    EXPECT_EQ(date.fault, DateFault::none) << text;
    return date.seconds;
}

std::string two(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

// Every day of 900 years as the standard library counts them.
TEST(Date, DaysAreThoseOfTheStandardLibrary) {
    using namespace std::chrono;
    for (sys_days day = sys_days(1582y / 10 / 15); day < sys_days(2500y / 1 / 1); day += days(1)) {
        const year_month_day parts(day);
        const int year = static_cast<int>(parts.year());
        const auto month = static_cast<int>(static_cast<unsigned>(parts.month())),
                   of_month = static_cast<int>(static_cast<unsigned>(parts.day()));
        const std::string text = std::to_string(year) + "-" + two(month) + "-" + two(of_month);
        ASSERT_EQ(read_date(text, DateOrder::year_first).seconds, static_cast<double>(day.time_since_epoch().count()) * 86'400.0)
            << text;
    }
}

// Which days there are: each number of a day in each month of 402 years.
TEST(Date, DaysThatThereAreNotAreThoseOfTheStandardLibrary) {
    using namespace std::chrono;
    for (int year = 1799; year <= 2200; ++year)
        for (int month = 0; month <= 13; ++month)
            for (int day = 0; day <= 32; ++day) {
                const bool there = year_month_day(std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                                  std::chrono::day(static_cast<unsigned>(day)))
                                       .ok();
                const std::string text = std::to_string(year) + "-" + two(month) + "-" + two(day);
                ASSERT_EQ(read_date(text, DateOrder::year_first).fault, there ? DateFault::none : DateFault::impossible) << text;
            }
}

TEST(Date, TimesAreThoseOfTheDateProgram) {
    if (!has_tool("date")) GTEST_SKIP() << "date is not installed";
    std::mt19937 random(11);
    const auto up_to = [&](unsigned most) { return static_cast<int>(random() % (most + 1)); };
    std::vector<std::string> texts;
    std::string lines;
    for (int i = 0; i < 300; ++i) {
        std::string text = std::to_string(1600 + up_to(799)) + "-" + two(1 + up_to(11)) + "-" + two(1 + up_to(27)) +
                           (i % 2 == 0 ? "T" : " ") + two(up_to(23)) + ":" + two(up_to(59)) + ":" + two(up_to(59));
        if (i % 3 == 0) text += "Z";
        if (i % 3 == 1) text += (i % 2 == 0 ? "+" : "-") + two(up_to(13)) + ":" + two(up_to(59));
        texts.push_back(text);
        lines += text + "\n";
    }
    const Folder folder;
    const Ending ending = run_tool(folder, {"env", "TZ=UTC0", "LC_ALL=C", "date", "-f", "-", "+%s"}, lines);
    if (ending.code != 0) GTEST_SKIP() << "this date reads no dates of a file: " << ending.err;
    std::istringstream told(ending.out);
    for (const std::string& text : texts) {
        double expected = 0;
        ASSERT_TRUE(told >> expected);
        EXPECT_EQ(seconds(text), expected) << text;
    }
}

TEST(Date, IsWrittenInManyWays) {
    const double leap_day = seconds("2024-02-29");
    EXPECT_EQ(leap_day, 1'709'164'800);  // date -u -d 2024-02-29 +%s
    EXPECT_EQ(seconds("2024/02/29"), leap_day);
    EXPECT_EQ(seconds("29.2.2024", DateOrder::day_first), leap_day);
    EXPECT_EQ(seconds("29-02-2024", DateOrder::day_first), leap_day);
    EXPECT_EQ(seconds("2/29/2024", DateOrder::month_first), leap_day);
    EXPECT_EQ(seconds("2024-02-29", DateOrder::day_first), leap_day);
    EXPECT_EQ(seconds("29.02.2024 13:05", DateOrder::day_first), leap_day + 13 * 3600 + 5 * 60);
    EXPECT_EQ(seconds("2024-02-29T13:05:07.25Z"), leap_day + 13 * 3600 + 5 * 60 + 7.25);
    EXPECT_EQ(seconds("2024-02-29T00:30+0100"), leap_day - 1800);
    EXPECT_EQ(seconds("2024-02-29T00:30-01"), leap_day + 5400);
    EXPECT_EQ(seconds("2016-12-31T23:59:60Z"), seconds("2017-01-01"));
    EXPECT_EQ(seconds("2024-02"), seconds("2024-02-01"));
    EXPECT_EQ(seconds("2024-Q4"), seconds("2024-10-01"));
    EXPECT_EQ(seconds("2024Q1"), seconds("2024-01-01"));
    EXPECT_EQ(seconds("1582-10-15"), -12'219'292'800);  // date -u -d 1582-10-15 +%s
}

TEST(Date, SaysWhyItIsNone) {
    for (const char* other : {"", "2024", "20240229", "2024-2-29", "24-02-29", "2024-02-29T", "2024-02-29T13",
                              "2024-02-29T13:05:", "2024-02-29T13:05:07.", "2024-02-29x", "2024-02/29", "1.2.2024", "2024-Q5",
                              "2024-Q1-02", "2024-02 13:05", "2024-02-29T13:05+1", "-2024-02-29", "today", "0.53"})
        EXPECT_EQ(read_date(other, DateOrder::year_first).fault, DateFault::other) << other;
    for (const char* wrong : {"2023-02-29", "1900-02-29", "2024-04-31", "2024-13-01", "2024-00-01", "2024-01-00",
                              "2024-02-29T24:00", "2024-02-29T13:60", "2024-02-29T13:00:60", "2024-02-29T13:00+24:00"})
        EXPECT_EQ(read_date(wrong, DateOrder::year_first).fault, DateFault::impossible) << wrong;
    EXPECT_EQ(read_date("31.4.2024", DateOrder::day_first).fault, DateFault::impossible);
    EXPECT_EQ(read_date("13/5/2024", DateOrder::month_first).fault, DateFault::impossible);
    EXPECT_EQ(read_date("1.2.24", DateOrder::day_first).fault, DateFault::other) << "a year has four digits";
    for (const char* old : {"1582-10-14", "1066-10-14", "0001-01-01"})
        EXPECT_EQ(read_date(old, DateOrder::year_first).fault, DateFault::old) << old;
}

TEST(Date, TellsTheNumbersThatMayBeDayAndMonth) {
    const auto parts = day_and_month("31/12/2024 10:00");
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->first, 31);
    EXPECT_EQ(parts->second, 12);
    ASSERT_TRUE(day_and_month("2/29/2024"));
    for (const char* other : {"2024-02-29", "1.2", "1.2.3", "0.53", "1/2/2024x", ""}) EXPECT_FALSE(day_and_month(other)) << other;
}

}  // namespace
}  // namespace tactics::date_test
