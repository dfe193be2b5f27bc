// SPDX-License-Identifier: Apache-2.0
// The library names wishes; the command line, and these tests with it, spell them as options.
#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tactics/layout/place.h"

namespace tactics::spelling_test {
namespace {

// Before the first test: what a message says must not hang on which runs first.
[[maybe_unused]] const bool kSpelled = [] {
    spell_wishes_with("--");
    return true;
}();

std::string complaint() {
    Sheet sheet;
    sheet.paper = find_paper("a4", "test");
    sheet.medium = &find_medium("swell", "test");
    sheet.margin = -1;
    try {
        place_on(sheet, 1);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Spelling, IsTheWishItselfUntilAProgramSaysHowItsUsersWriteIt) {
    EXPECT_EQ(complaint(), "--margin: a margin cannot be less than nothing; give 0mm or more");
    spell_wishes_with("");
    const std::string plain = complaint();
    spell_wishes_with("--");
    EXPECT_EQ(plain, "margin: a margin cannot be less than nothing; give 0mm or more");
}

}  // namespace
}  // namespace tactics::spelling_test
