// SPDX-License-Identifier: Apache-2.0
#include "tactics/recipe.h"

#include <gtest/gtest.h>

#include "filters/list.h"
#include "tactics/error.h"

namespace tactics::recipe_test {
namespace {

std::string message_of(std::string_view text) {
    try {
        check(parse_recipe(text, "lines.recipe", filters()));
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::usage);
        return error.what();
    }
    return "no error";
}

TEST(Recipe, NamesThePlaceAndTheNearestFilter) {
    EXPECT_EQ(message_of("# lines\ninvert\n\nintvert  # typing slip\n"),
              "lines.recipe:4: there is no filter \"intvert\" (invert?); see tactics list filters");
}

TEST(Recipe, RefusesWhatIsNotARecipe) {
    EXPECT_EQ(message_of("# nothing\n\n"), "lines.recipe: there is no filter in this recipe");
    EXPECT_EQ(message_of(std::string_view("\x89PNG\0\0", 6)),
              "lines.recipe: this is not a text file; a recipe is plain text, one filter a line");
    EXPECT_EQ(message_of("invert 3"), "lines.recipe:1: \"3\" is not a setting; write NAME=VALUE without spaces around =");
}

TEST(Recipe, RefusesASettingThatIsSetTwice) {
    EXPECT_EQ(message_of("invert\nsobel blur=1mm thin=no blur=2mm"), "lines.recipe:2: sobel blur is set twice; set it once");
    EXPECT_EQ(message_of("sobel blur=1mm blur=1mm"), "lines.recipe:1: sobel blur is set twice; set it once");
    EXPECT_EQ(message_of("sobel blur=1mm\nsobel blur=2mm"), "no error");
}

TEST(Recipe, TextReadsBackToTheSameRecipe) {
    const Recipe recipe = parse_recipe("# black for white\r\ninvert\r\n  invert # twice", "own", filters());
    EXPECT_EQ(recipe.summary, "black for white");
    ASSERT_EQ(recipe.steps.size(), 2u);
    EXPECT_EQ(recipe.steps[1].place, "own:3");
    EXPECT_EQ(to_text(recipe), "# black for white\ninvert\ninvert\n");
    EXPECT_EQ(to_text(parse_recipe(to_text(recipe), "own", filters())), to_text(recipe));
}

}  // namespace
}  // namespace tactics::recipe_test
