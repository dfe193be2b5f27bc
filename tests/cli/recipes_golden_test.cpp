// SPDX-License-Identifier: Apache-2.0
// What each recipe that comes with the program makes of a small sample, through the whole program to a bare PNG.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "filters/list.h"
#include "samples/draw/scenes.h"
#include "tests/filters/weights.h"
#include "tests/golden/golden.h"

namespace tactics::recipes_golden_test {
namespace {

namespace fs = std::filesystem;

// What the recipe is for; a balloon for those that are for anything.
std::string_view subject_of(std::string_view recipe) {
    if (recipe == "photo") return "house";
    if (recipe == "portrait") return "face-ben";
    if (recipe == "diagram") return "chart";
    if (recipe == "map" || recipe == "borders" || recipe == "regions") return "map";
    if (recipe == "line-art") return "line-art";
    return "balloon";
}

class RecipeGolden : public testing::TestWithParam<std::string_view> {};

TEST_P(RecipeGolden, LooksAsItDid) {
    constexpr int kSize = 256;
    const std::string recipe(GetParam());
    if (recipe == "photo" || recipe == "portrait") SKIP_WITHOUT_WEIGHTS();
    const fs::path folder = fs::path(TACTICS_BINARY_DIR) / "recipe-pages";
    fs::create_directories(folder);
    const std::string input = (folder / (recipe + "-input.png")).string(), page = (folder / (recipe + ".png")).string();
    golden::write_png(samples::draw_scene(subject_of(recipe), kSize), input);
    fs::remove(page);
    const std::string command =
        std::string(TACTICS_PROGRAM) + " convert '" + input + "' -o '" + page + "' --bare --as-drawn --quiet --recipe " + recipe;
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const Image drawn = golden::read_png(page);
    EXPECT_EQ(std::max(drawn.width, drawn.height), kSize) << "a bare page has the pixels of its picture";
    // Compilers round another way here and there, and where a line begins may hang on it.
    golden::expect_golden("recipes/" + recipe, drawn, 0.01);
}

std::vector<std::string_view> names() {
    std::vector<std::string_view> all;
    for (const NamedRecipe& recipe : named_recipes()) all.push_back(recipe.name);
    return all;
}

std::string test_name(const testing::TestParamInfo<std::string_view>& tested) {
    std::string name(tested.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Recipes, RecipeGolden, testing::ValuesIn(names()), test_name);

}  // namespace
}  // namespace tactics::recipes_golden_test
