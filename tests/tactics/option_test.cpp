// SPDX-License-Identifier: Apache-2.0
#include "tactics/option.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>
#include <string>

#include "tactics/error.h"

namespace tactics::option_test {
namespace {

constexpr Option kTold[] = {
    {.name = "author", .type = Option::Type::words, .summary = "who"},
    {.name = "day", .type = Option::Type::date, .summary = "when"},
};

std::string error_of(std::string_view option, const std::string& text) {
    try {
        Settings(kTold).set(option, text, "--set", "format");
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(Option, WordsAreOneLineAsTheyWereGiven) {
    Settings settings(kTold);
    EXPECT_TRUE(settings.is_default("author"));
    EXPECT_EQ(settings.words("author"), "");
    settings.set("author", "Käthe = Söhne", "", "format");
    EXPECT_EQ(settings.words("author"), "Käthe = Söhne");
    EXPECT_FALSE(settings.is_default("author"));
    settings.set("author", "", "", "format");
    EXPECT_TRUE(settings.is_default("author"));
    for (const std::string& bad :
         {std::string("two\nlines"), std::string("\xFF"), std::string("a\x1B[2J"), std::string(501, 'a')})
        EXPECT_NE(error_of("author", bad).find("format author cannot be"), std::string::npos) << bad;
    EXPECT_EQ(error_of("author", std::string(500, 'a')), "");
}

// The calendar of the C library says which days there are.
TEST(Option, DaysAreThoseOfTheCalendarThatZipHolds) {
    for (int year = 1978; year <= 2110; year += year < 2000 || year > 2099 ? 1 : 7)
        for (int month = 0; month <= 13; ++month)
            for (int day = 27; day <= 32; ++day) {
                std::tm made{};
                made.tm_year = year - 1900;
                made.tm_mon = month - 1;
                made.tm_mday = day;
                made.tm_hour = 12;
                timegm(&made);
                const bool exists = made.tm_mday == day && made.tm_mon == month - 1 && made.tm_year == year - 1900;
                char text[40];
                std::snprintf(text, sizeof text, "%04d-%02d-%02d", year, month, day);
                EXPECT_EQ(error_of("day", text).empty(), exists && year >= 1980 && year <= 2107) << text;
            }
    for (const char* bad : {"2026", "2026-3-31", "31.03.2026", "2026-03-31T00:00", "2026/03/31", "+026-03-31", "2026-0a-01"})
        EXPECT_NE(error_of("day", bad).find("a day from 1980-01-01 to 2107-12-31"), std::string::npos) << bad;
    EXPECT_EQ(error_of("day", ""), "");
}

}  // namespace
}  // namespace tactics::option_test
