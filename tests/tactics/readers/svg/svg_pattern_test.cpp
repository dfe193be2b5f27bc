// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_pattern.h"

#include <gtest/gtest.h>

#include <string>

#include "tactics/readers/xml.h"

namespace tactics::svg_pattern_test {
namespace {

// As poppler writes a page: each surface has a pattern and a group of its own.
std::string pattern(int number, const std::string& path) {
    const std::string n = std::to_string(number);
    return "<clipPath id='clip" + n + "'><rect width='8' height='8'/></clipPath><g id='surface" + n + "' clip-path='url(#clip" +
           n + ")'><path d='" + path + "' stroke='black'/></g><pattern id='pattern" + n +
           "' patternUnits='userSpaceOnUse' width='8' height='8'><use xlink:href='#surface" + n + "'/></pattern>";
}

TEST(SvgPattern, IsTheSameForTheSameContent) {
    const std::string slash = "M0 8 L8 0", back = "M0 0 L8 8";
    const std::string file =
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='200' height='100'><defs>" +
        pattern(1, slash) + pattern(2, back) + pattern(3, slash) +
        "<pattern id='own' width='8' height='8'><path d='M0 8 L8 0'/></pattern></defs></svg>";
    const auto numbers = pattern_numbers(parse_xml(file, "patterns.svg"));
    ASSERT_EQ(numbers.size(), 4u);
    EXPECT_EQ(numbers.at("pattern1"), numbers.at("pattern3"));
    EXPECT_NE(numbers.at("pattern1"), numbers.at("pattern2"));
    EXPECT_NE(numbers.at("pattern1"), numbers.at("own"));
    for (const auto& [id, number] : numbers) {
        EXPECT_GT(number, 1) << id;
        EXPECT_LT(number, 2) << id;
    }
}

// A pattern that holds itself, or a group that is not there.
TEST(SvgPattern, MayLeadNowhere) {
    const auto numbers = pattern_numbers(
        parse_xml("<svg xmlns='http://www.w3.org/2000/svg'><pattern id='a'><use href='#a'/></pattern><pattern id='b'><use "
                  "href='#none'/></pattern></svg>",
                  "patterns.svg"));
    EXPECT_EQ(numbers.size(), 2u);
}

}  // namespace
}  // namespace tactics::svg_pattern_test
