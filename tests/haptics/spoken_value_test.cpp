// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/spoken_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "tactics/text/number.h"

namespace tactics::spoken_value_test {
namespace {

TEST(SpokenValue, SaysNoMoreThanAPlotCanMean) {
    struct Case {
        double value, step, largest;
        const char* words;
    };
    for (const Case& one :
         {Case{2.5, 0.02, 10, "2.5"}, Case{2.4967, 0.02, 10, "2.5"}, Case{-2.5, 0.02, 10, "-2.5"}, Case{-0.001, 0.02, 10, "0"},
          Case{346'912, 2000, 1e6, "347000"}, Case{0.00012, 2e-6, 1e-3, "0.00012"},
          Case{1.2e-9, 2e-11, 1e-8, "1.2 times 10 to the minus 9"}, Case{-1.2e-9, 2e-11, 1e-8, "-1.2 times 10 to the minus 9"},
          Case{0, 2e-11, 1e-8, "0"}, Case{3e18, 1e16, 1e19, "3 times 10 to the 18"}, Case{NAN, 1, 1, "not known"},
          Case{1.23456789, 0, 0, "1.234568"}})
        EXPECT_EQ(spoken_number(one.value, one.step, one.largest).english(), one.words);
}

// Reads back what is said: never an exponent's letter, and never more than half a step away.
TEST(SpokenValue, IsWithinHalfAStep) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> power(-12, 17), share(-1, 1);
    for (int i = 0; i < 20'000; ++i) {
        const double largest = std::pow(10.0, power(random)), value = largest * share(random), step = largest / 500;
        const std::string words = spoken_number(value, step, largest).english();
        std::string figure = words;
        double factor = 1;
        if (const auto at = words.find(" times 10 to the "); at != std::string::npos) {
            figure = words.substr(0, at);
            std::string exponent = words.substr(at + 17);
            if (exponent.starts_with("minus ")) exponent = "-" + exponent.substr(6);
            factor = std::pow(10.0, parse_number(exponent).value());
        }
        EXPECT_EQ(figure.find_first_not_of("-.0123456789"), std::string::npos) << words;
        const auto read = parse_number(figure);
        ASSERT_TRUE(read) << words;
        EXPECT_LE(std::abs(*read * factor - value), step / 2 * (1 + 1e-9)) << words << " of " << value;
        EXPECT_LE(figure.size(), 17u) << words;
    }
}

TEST(SpokenValue, AStepIsAFiveHundredthOrWhatTheDeviceKnows) {
    EXPECT_DOUBLE_EQ(telling_step({0, 10, 100}, false, 3), 0.02);
    EXPECT_DOUBLE_EQ(telling_step({10, 0, 100}, false, 3), 0.02);
    EXPECT_DOUBLE_EQ(telling_step({0, 10, 100, 1}, false, 3), 0.1);
    // 500 steps of a logarithmic axis lead from one end to the other.
    double value = 0.01;
    for (int i = 0; i < 500; ++i) value += telling_step({0.01, 1000, 100}, true, value);
    EXPECT_NEAR(value, 1000, 1e-6);
}

// The C library's calendar is another one.
TEST(SpokenValue, DatesAreThoseOfTheCalendar) {
    std::mt19937_64 random(11);
    std::uniform_int_distribution<long long> any(-12'000'000'000, 30'000'000'000);  // years 1589 to 2920
    for (int i = 0; i < 5'000; ++i) {
        const long long seconds = any(random);
        const auto time = static_cast<std::time_t>(seconds);
        std::tm parts{};
        ASSERT_NE(gmtime_r(&time, &parts), nullptr);
        char words[64];
        std::strftime(words, sizeof words, "%Y-%m-%d %H:%M:%S", &parts);
        const std::string whole = words;
        EXPECT_EQ(spoken_date(static_cast<double>(seconds), 5).english(), whole);
        EXPECT_EQ(spoken_date(static_cast<double>(seconds), 60).english(), whole.substr(0, 16));
        EXPECT_EQ(spoken_date(static_cast<double>(seconds), 86'400).english(), whole.substr(0, 10));
    }
    EXPECT_EQ(spoken_date(1'709'211'907.25, 0.02).english(), "2024-02-29 13:05:07.25");
    EXPECT_EQ(spoken_date(0.1 + 0.2, 0.1).english(), "1970-01-01 00:00:00.3");
    EXPECT_EQ(spoken_date(59.999, 0.1).english(), "1970-01-01 00:01:00");
    EXPECT_EQ(spoken_date(-0.5, 0.1).english(), "1969-12-31 23:59:59.5");
    EXPECT_EQ(spoken_date(1e300, 1).english().find("-"), std::string::npos);  // no year of the calendar
}

}  // namespace
}  // namespace tactics::spoken_value_test
