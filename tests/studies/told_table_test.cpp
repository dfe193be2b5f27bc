// SPDX-License-Identifier: Apache-2.0
// Tables in the reader's language: columns stand below each other whatever the letters, and a spreadsheet gets the same in every
// language.
#include "studies/told_table.h"

#include <gtest/gtest.h>

namespace tactics::told_table_test {
namespace {

const std::vector<ToldRow> kRows{
    {phrase("recipe"), phrase("crowded"), phrase("recall")}, {"a 1.5", "0.25", "17.0 %"}, {phrase("acuity"), "", "0.10-0.95"}};

TEST(ToldTable, IsReadInTheLanguageOfWhoReadsIt) {
    EXPECT_EQ(told_table(kRows, "en"),
              "recipe  crowded  recall\n"
              "a 1.5      0.25  17.0 %\n"
              "acuity        -  0.10-0.95\n");
    // The numbers have a comma, the name of a recipe has not.
    EXPECT_EQ(told_table(kRows, "de"),
              "Rezept   gedr\u00E4ngt  Trefferquote\n"
              "a 1.5        0,25  17,0 %\n"
              "Sch\u00E4rfe         -  0,10-0,95\n");
    EXPECT_EQ(told_csv(kRows), "recipe,crowded,recall\r\na 1.5,0.25,17.0 %\r\nacuity,,0.10-0.95\r\n");
}

}  // namespace
}  // namespace tactics::told_table_test
