// SPDX-License-Identifier: Apache-2.0
// Words of a key, in any order in the file.
#include <gtest/gtest.h>

#include "tactics/layout/key.h"
#include "tactics/rules/rule.h"
#include "tests/rules/pages.h"

namespace tactics::tests::key_words_test {
namespace {

TEST(KeyWords, AreFoundInAnyOrder) {
    Page page = blank_page();
    page.is_key = true;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < 60; ++i) {
        const double left = i * 7 % 2 == 0 ? 20 : 110, top = 10 + 4 * static_cast<double>(i * 7 % 60);
        const bool early = i % 3 == 0;
        BrailleLine line{{left + 1, top + 1}, std::vector<std::uint8_t>(kWordsFrom + 4, 0x3f)};
        for (std::size_t cell = 2; cell < kWordsFrom - (early ? 1 : 0); ++cell) line.cells[cell] = 0;
        wrong += early ? 1 : 0;
        page.braille.push_back(std::move(line));
        const std::size_t other = 59 - i;
        page.names.push_back({"words",
                              "k" + std::to_string(other),
                              {},
                              {other * 7 % 2 == 0 ? 20.0 : 110.0, 10 + 4 * static_cast<double>(other * 7 % 60), 30, 3}});
    }
    std::size_t found = 0;
    for (const Verdict& verdict : check_page(page, demands_of(find_medium("swell", "test"))))
        if (verdict.demand.rule->name == "key-words") found = verdict.findings.places.size();
    EXPECT_EQ(found, wrong);
}

}  // namespace
}  // namespace tactics::tests::key_words_test
