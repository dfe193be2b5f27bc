// SPDX-License-Identifier: Apache-2.0
// How many classes are chosen: as many as the picture has, not as many as its noise has.
#include "filters/level_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "filters/list.h"
#include "samples/draw/noise.h"

namespace tactics::level_choice_test {
namespace {

// Stripes of the levels, with even noise of at most `noise` to either side.
Image stripes(const std::vector<int>& levels, double noise) {
    Image image = make_image(120, 90, 1, 0.5, 0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double level = levels[static_cast<std::size_t>(x) * levels.size() / 120];
            const double chance = 2 * static_cast<double>(samples::chance(x, y, 3)) - 1;
            image.row(y)[x] = static_cast<std::uint8_t>(std::lround(std::clamp(level + noise * chance, 0.0, 255.0)));
        }
    return image;
}

Step kmeans(const std::string& settings) { return parse_step("kmeans " + settings, "test", filters()); }

int chosen(const Image& image, std::string* reason = nullptr) {
    Step step = kmeans("k=0");
    const ChosenSetting said = step.filter->settle(image, step.settings);
    if (reason != nullptr) *reason = said.why.english();
    EXPECT_EQ(said.setting, "k=" + std::to_string(step.settings.whole("k")));
    EXPECT_TRUE(said.can_be_changed());
    return step.settings.whole("k");
}

TEST(LevelChoice, AsManyAsThereAre) {
    for (const double noise : {0.0, 4.0, 12.0}) {
        EXPECT_EQ(chosen(stripes({120}, noise)), 1) << noise;
        EXPECT_EQ(chosen(stripes({40, 200}, noise)), 2) << noise;
        EXPECT_EQ(chosen(stripes({40, 120, 200}, noise)), 3) << noise;
        EXPECT_EQ(chosen(stripes({20, 90, 160, 230}, noise)), 4) << noise;
    }
}

TEST(LevelChoice, FaintOnesAsWell) {
    EXPECT_EQ(chosen(stripes({100, 104, 108}, 0)), 3);
    EXPECT_EQ(chosen(stripes({100, 130, 160}, 5)), 3);
}

TEST(LevelChoice, EvenShadesNeedFourAndNoPictureMoreThanTheTextures) {
    std::vector<int> ramp, many;
    for (int i = 0; i < 120; ++i) ramp.push_back(2 * i);
    EXPECT_EQ(chosen(stripes(ramp, 0)), 4);
    // A few far ones and a few between: each takes a class of its own.
    std::string reason;
    const auto variance = [](int k) { return 1.0 / k; };
    const LevelChoice most = choose_levels(variance, 0, 1);
    EXPECT_EQ(most.k, 5);
    EXPECT_TRUE(most.ended);
    EXPECT_EQ(reason_of(most, false).english(), "5 greys explain 80 % of its variance, and more textures no finger tells apart");
    EXPECT_EQ(choose_levels(variance, 0.4, 1).k, 3);
    EXPECT_EQ(choose_levels(variance, 2, 1).k, 1);
    EXPECT_EQ(choose_levels([](int) { return 0.0; }, 0, 1).k, 1);
    EXPECT_EQ(choose_levels([](int k) { return k < 3 ? 1.0 : 0.0; }, 0, 7).k, 7) << "what must be is more than what may be";
}

TEST(LevelChoice, RunningWithItIsRunningWithItsNumber) {
    for (const int channels : {1, 3}) {
        Image image = stripes({30, 110, 200}, 9);
        if (channels == 3) {
            Image colour = make_image(image.width, image.height, 3, 0.5, 0);
            for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                colour.pixels[3 * i] = image.pixels[i];
                colour.pixels[3 * i + 1] = image.pixels[i] / 2;
                colour.pixels[3 * i + 2] = static_cast<std::uint8_t>(255 - image.pixels[i]);
            }
            image = colour;
        }
        const std::string how = channels == 3 ? " colour=yes" : "";
        Step open = kmeans("k=0" + how);
        const Step three = kmeans("k=3" + how);
        const Image one = std::get<Image>(open.filter->apply(image, open.settings)),
                    other = std::get<Image>(three.filter->apply(image, three.settings));
        EXPECT_EQ(one.pixels, other.pixels) << channels;
        EXPECT_FALSE(open.filter->settle(image, open.settings).empty());
        EXPECT_EQ(open.settings.whole("k"), 3);
        EXPECT_TRUE(open.filter->settle(image, open.settings).empty()) << "there is nothing left to choose";
    }
}

TEST(LevelChoice, ARunTellsAndKeepsWhatWasChosen) {
    Recipe recipe = parse_recipe("invert\nkmeans k=0\nkmeans k=2\n", "test", filters());
    std::vector<ChosenSetting> said;
    const Image image = stripes({40, 120, 200}, 0);
    const Artwork settled = run_settling(recipe, image, said);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].words().english(), "kmeans k=3: 3 greys explain 100 % of its variance");
    EXPECT_EQ(to_text(recipe), "invert\nkmeans k=3\nkmeans k=2\n");
    EXPECT_EQ(std::get<Image>(settled).pixels,
              std::get<Image>(run(parse_recipe("invert\nkmeans k=0\nkmeans k=2\n", "test", filters()), image)).pixels);
}

TEST(LevelChoice, EdgesKeepFewerClassesThanThereAre) {
    EdgeMap edges{40, 30, 0.5, false, std::vector<float>(1200), {}, 0};
    for (std::size_t i = 0; i < edges.strength.size(); ++i)
        edges.strength[i] = i % 40 == 20 ? 90.0f : i % 40 == 10 ? 30.0f : 0.0f;
    Step step = kmeans("k=0 keep=1");
    EXPECT_FALSE(step.filter->settle(edges, step.settings).empty());
    EXPECT_GE(step.settings.whole("k"), 2);
    const auto kept = std::get<EdgeMap>(step.filter->apply(edges, step.settings));
    EXPECT_EQ(std::count_if(kept.strength.begin(), kept.strength.end(), [](float s) { return s > 0; }), 30);
}

}  // namespace
}  // namespace tactics::level_choice_test
