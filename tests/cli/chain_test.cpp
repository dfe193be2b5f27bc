// SPDX-License-Identifier: Apache-2.0
#include "cli/chain.h"

#include <gtest/gtest.h>

#include "filters/list.h"
#include "tests/cli/fake_disk.h"
#include "tests/cli/tool.h"

namespace tactics::chain_test {
namespace {

using tests::error_of;
using tests::FakeDisk;
using Words = std::vector<std::string>;

// The steps that are run for those words, each on a line.
std::string steps(const Words& words, const FakeDisk& fake = {}) {
    const Given given = parse_words(*find_command("convert"), words);
    const RecipeWish chain = read_chain(given, fake.disk());
    if (!chain.base) return "auto";
    Recipe recipe = finish(chain, *chain.base);
    recipe.summary.clear();
    return to_text(recipe);
}

TEST(Chain, IsAutoUntilARecipeOrAFilterIsNamed) {
    EXPECT_EQ(steps({}), "auto");
    EXPECT_EQ(steps({"--recipe", "auto", "--filter", "invert"}), "auto");
    EXPECT_EQ(steps({"--filter", "invert"}), "resample\ninvert\n");
}

TEST(Chain, HasResampleInFrontUnlessItSaysSo) {
    EXPECT_EQ(steps({"-f", "resample dpi=100", "-f", "invert"}), "resample dpi=100\ninvert\n");
    EXPECT_EQ(steps({"-f", "invert", "-f", "resample dpi=100"}), "invert\nresample dpi=100\n");
    EXPECT_EQ(steps({"-f", "invert", "-s", "resample.dpi=100"}), "resample dpi=100\ninvert\n");
}

TEST(Chain, AnEdgeMapIsCutAtItsEnd) { EXPECT_EQ(steps({"-f", "sobel blur=0.5mm"}), "resample\nsobel blur=0.5mm\nthreshold\n"); }

TEST(Chain, AnEdgeMapThatIsScoredIsNot) {
    const RecipeWish chain = read_chain(parse_words(*find_command("convert"), {"-f", "sobel blur=0.5mm"}), FakeDisk{}.disk());
    EXPECT_EQ(to_text(assemble(chain, *chain.base)), "resample\nsobel blur=0.5mm\n");
}

TEST(Chain, OfARecipeFileComesBeforeFilters) {
    FakeDisk fake;
    fake.files["my"] = "# mine\ninvert\n";
    fake.files["none"] = "invert\n";
    EXPECT_EQ(steps({"-r", "my", "-f", "sobel", "-f", "threshold"}, fake), "resample\ninvert\nsobel\nthreshold\n");
    // A name in the list is not a file, unless it is spelled as one.
    EXPECT_EQ(steps({"-r", "none"}, fake), steps({"-r", "none"}));
    fake.files["./none"] = fake.files["none"];
    EXPECT_EQ(steps({"-r", "./none"}, fake), "resample\ninvert\n");
}

TEST(Chain, SetChangesEveryStepOfThatName) {
    EXPECT_EQ(steps({"-f", "resample", "-f", "sobel", "-f", "sobel blur=1mm", "-f", "threshold", "--set", "sobel.blur=0.5mm"}),
              "resample\nsobel blur=0.5mm\nsobel blur=0.5mm\nthreshold\n");
}

TEST(Chain, EveryNamedRecipeCanBeSavedAndReadBack) {
    for (const NamedRecipe& named : named_recipes()) {
        const std::string text = steps({"-r", std::string(named.name)});
        FakeDisk fake;
        fake.files["saved.recipe"] = text;
        EXPECT_EQ(steps({"-r", "saved.recipe"}, fake), text) << named.name;
    }
}

TEST(Chain, EverySampleRecipeIsOne) {
    for (const auto& entry : std::filesystem::directory_iterator(TACTICS_SOURCE_DIR "/samples/recipes")) {
        const Recipe recipe = parse_recipe(tests::bytes_of(entry.path()), entry.path().filename().string(), filters());
        EXPECT_FALSE(recipe.summary.empty()) << recipe.name;
        EXPECT_EQ(error_of([&] { check(recipe); }), "no error");
    }
}

// What is saved has six decimals; so has what is used.
TEST(Chain, ASettingIsTheNumberThatIsSaved) {
    const Words words{"-f", "sobel blur=0.30000003mm", "-f", "threshold"};
    const Given given = parse_words(*find_command("convert"), words);
    const RecipeWish chain = read_chain(given, FakeDisk().disk());
    EXPECT_EQ(chain.base->steps[0].settings.number("blur"), 0.3);
    EXPECT_EQ(steps({"-f", "sobel blur=0.1234567in"}), steps({"-f", "sobel blur=3.1358mm"}));
}

std::string refused(const Words& words, const FakeDisk& fake = {}) {
    return error_of([&] { steps(words, fake); });
}

TEST(Chain, TellsTheNearestName) {
    EXPECT_EQ(refused({"-f", "sobbel"}), "1 --filter 1: there is no filter \"sobbel\" (sobel?); see tactics list filters");
    EXPECT_EQ(refused({"-f", "sobel", "--set", "soble.blur=1"}),
              "1 --set 1: there is no filter or format \"soble\" (sobel?); see tactics list filters formats");
    EXPECT_EQ(refused({"-f", "invert", "--set", "sobel.blur=1"}),
              "1 --set 1: recipe made of --filter has no filter sobel; it has resample, invert");
    EXPECT_EQ(refused({"--set", "sobel.blurr=1"}).substr(0, 50), "1 --set 1: sobel has no setting \"blurr\" (blur?); i");
    for (const std::string text : {"sobel", "sobel=1", ".blur=1", "sobel.=1", "="})
        EXPECT_EQ(refused({"--set", text}),
                  "1 --set 1: \"" + text + "\" is not a setting; write NAME.OPTION=VALUE, for example png.dpi=300");
    EXPECT_EQ(refused({"-r", "missing.recipe"}), "2 missing.recipe: there is no such file");
    FakeDisk folders;
    folders.folders = {".", "own.recipe"};
    for (const std::string name : {".", "own.recipe"})
        EXPECT_EQ(refused({"-r", name}, folders),
                  "1 --recipe: " + name + " is a folder; name a recipe file in it, or a recipe of tactics list recipes");
    EXPECT_EQ(
        refused({"-f", "invert", "--detail", "3"}),
        "1 --detail: recipe made of --filter has no filter that keeps to a budget of line, such as outlines or strongest; leave "
        "--detail out or use --recipe photo");
    EXPECT_EQ(refused({"--detail", "contour"}).substr(0, 52), "1 --detail: it cannot be \"contour\" (contours?); it i");
}

TEST(Chain, DetailTurnsTheStrongest) {
    const Words own{"-f", "contours scene=1", "-f", "strongest line=100mm", "-f", "trace", "-f", "separate"};
    const auto with = [&](const std::string& detail) {
        Words words = own;
        words.insert(words.end(), {"--detail", detail});
        return steps(words);
    };
    EXPECT_EQ(with("touch"), steps(own));
    EXPECT_NE(with("3").find("strongest line=300mm\n"), std::string::npos);
    EXPECT_NE(with("0.5").find("contours scene=1\nstrongest line=50mm\n"), std::string::npos);
    EXPECT_EQ(with("contours"), steps({"-f", "contours", "-f", "trace"}));  // all contours, the fine ones, too
    Words coarse = own;
    coarse.insert(coarse.end(), {"--detail", "contours", "--set", "contours.scene=2"});
    EXPECT_EQ(steps(coarse), steps({"-f", "contours scene=2", "-f", "trace"}));
    // What is offered is accepted, and the next thousandth is not.
    const std::string range =
        " is out of range; with recipe made of --filter it is 0.01 to 1000 times the line that touch allows";
    for (const std::string bad : {"1e99", "1000.001", "0.009", "0", "-1"}) {
        EXPECT_EQ(error_of([&] { with(bad); }), "1 --detail: " + bad + range);
    }
    for (const std::string good : {"1000", "0.01"}) EXPECT_EQ(error_of([&] { with(good); }), "no error") << good;
}

TEST(Chain, DetailDrawsTheContoursThatOutlinesWereMadeFrom) {
    const Words traced{"-f", "resample dpi=50", "-f", "contours map=auto", "-f", "trace", "-f", "simplify"};
    EXPECT_EQ(steps({"-r", "photo", "--detail", "contours"}), steps(traced));
    EXPECT_NE(steps({"-r", "photo", "--detail", "contours", "--set", "nest.map=plain"}).find("contours\ntrace"),
              std::string::npos);
    EXPECT_NE(steps({"-r", "photo", "--detail", "2"}).find("line=280mm"), std::string::npos);
    EXPECT_EQ(refused({"-f", "outlines", "--detail", "contours"}).substr(0, 2), "1 ");
    EXPECT_EQ(
        refused({"-r", "photo", "--detail", "contours", "--set", "nest.smallest=5mm"}),
        "1 --set 1: --detail contours draws every contour, without nest, so nest.smallest would do nothing; leave out one of "
        "the two");
}

TEST(Chain, WhatIsPutBehindCanBeSet) {
    EXPECT_NE(steps({"-f", "nest map=plain", "--set", "outlines.line=90mm"}).find("outlines line=90mm"), std::string::npos);
    EXPECT_NE(steps({"-f", "nest map=plain", "--detail", "2"}).find("outlines line=280mm"), std::string::npos);
    EXPECT_NE(steps({"-f", "sobel", "--set", "threshold.level=90"}).find("threshold level=90"), std::string::npos);
}

TEST(Chain, ADetailThatNoPictureAllowsIsToldBeforeOneIsOpened) {
    for (const std::string bad : {"0", "-1", "100000"})
        EXPECT_TRUE(refused({"--detail", bad}).starts_with("1 --detail: " + bad + " is out of range; with recipe photo it is "))
            << refused({"--detail", bad});
}

}  // namespace
}  // namespace tactics::chain_test
