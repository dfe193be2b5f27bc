// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/number.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace tactics::number_test {
namespace {

// As the library of C reads it, to the last bit: the nearest double. It reads more than is a number here, such as 0x1 and blanks.
void expect_as_read_by_c(const std::string& text) {
    char* end = nullptr;
    errno = 0;
    const double value = std::strtod(text.c_str(), &end);
    const bool is_number = !text.empty() && end == text.c_str() + text.size() && std::isfinite(value);
    if (errno == ERANGE) return;  // too near to 0 for a double
    const auto told = parse_number(text);
    ASSERT_EQ(told.has_value(), is_number) << text;
    if (!told) return;
    EXPECT_EQ(*told, value) << text;
    EXPECT_EQ(std::signbit(*told), std::signbit(value)) << text;
}

TEST(Number, IsTheNearestToWhatIsWritten) {
    std::mt19937 random(1);
    const auto below = [&](unsigned count) { return static_cast<std::size_t>(random() % count); };
    const std::string letters = "0123456789012345678901234567890.-+e";
    for (int i = 0; i < 200'000; ++i) {
        std::string text(below(3) == 0 ? "-" : "");
        const std::size_t digits = below(20), point = below(22);
        for (std::size_t k = 0; k < digits; ++k) {
            if (k == point) text += '.';
            text += static_cast<char>('0' + below(10));
        }
        if (point == digits) text += '.';
        if (below(8) == 0) text += "e" + std::to_string(static_cast<int>(below(60)) - 30);
        expect_as_read_by_c(text);
        // Any letters that numbers have; two signs side by side are none.
        text.clear();
        for (std::size_t k = below(9); k > 0; --k) text += letters[below(static_cast<unsigned>(letters.size()))];
        if (text.starts_with("+-")) continue;
        expect_as_read_by_c(text);
    }
    for (const char* text : {"",
                             "-",
                             ".",
                             "-.",
                             "+",
                             "1.",
                             ".5",
                             "-.5",
                             "-0",
                             "0.1",
                             "9007199254740993",
                             "999999999999999",
                             "0.000000000000001",
                             "00000000000000000001",
                             "1..2",
                             "1.2.3",
                             "1-",
                             "1 ",
                             "1e",
                             "1e5",
                             "1e400"})
        expect_as_read_by_c(text);
}

}  // namespace
}  // namespace tactics::number_test
