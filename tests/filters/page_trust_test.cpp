// SPDX-License-Identifier: Apache-2.0
// How far a page is trusted: what is expected of it, from chances that are known and from scenes that are clear or are not.
#include "filters/page_trust.h"

#include <gtest/gtest.h>

#include "tests/filters/pictures.h"
#include "tests/filters/weights.h"

namespace tactics::page_trust_test {
namespace {

using pictures::Chance;

// Three faces in a row; an arc of 4 sides between the first two, one of 6 between the last.
RegionTree row_of_three(bool learned) {
    RegionTree tree;
    tree.learned = learned;
    tree.nodes.resize(5);
    for (const int length : {4, 6}) {
        RegionArc arc;
        const auto number = static_cast<std::uint32_t>(tree.arcs.size());
        for (int i = 0; i <= length; ++i) arc.points.push_back({10.0 * number, static_cast<double>(i)});
        arc.faces = {number, number + 1};
        arc.level = 100;
        tree.arcs.push_back(arc);
    }
    return tree;
}

TEST(PageTrust, ExpectsWhatTheChancesSay) {
    const auto features = trust_features_of(row_of_three(true), {{0, 1, 1}}, std::array{0.9f, 0.2f});
    ASSERT_TRUE(features);
    EXPECT_FLOAT_EQ((*features)[0], 0.9f);
    EXPECT_FLOAT_EQ((*features)[1], 3.6f / (3.6f + 1.2f));
    EXPECT_FALSE(trust_features_of(row_of_three(true), {{0, 0, 0}}, std::array{0.9f, 0.2f})) << "nothing is drawn";
}

// Whatever the weights are fitted to next.
TEST(PageTrust, GrowsWithWhatIsSureAndFallsWithWhatIsMissed) {
    for (const bool learned : {true, false}) {
        const auto trust = [&](float drawn, float missed) {
            return trust_of(row_of_three(learned), {{0, 1, 1}}, std::array{drawn, missed}).value();
        };
        EXPECT_GT(trust(0.95f, 0.1f).line, trust(0.6f, 0.1f).line) << learned;
        EXPECT_GT(trust(0.9f, 0.05f).found, trust(0.9f, 0.5f).found) << learned;
        EXPECT_GT(trust(0.95f, 0.05f).agreement(), 0.7) << learned;
        EXPECT_LT(trust(0.5f, 0.45f).agreement(), 0.56) << learned;
    }
}

class TrustBy : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (GetParam() == std::string("learned")) SKIP_WITHOUT_WEIGHTS();
    }
    std::optional<Trust> trust(const Image& image, const std::string& settings = "") const {
        const Artwork tree = pictures::filtered(std::string("nest map=") + GetParam(), image);
        return std::get<Drawing>(pictures::filtered("outlines " + settings, tree)).trust;
    }
};

Image on_page(Image image) {
    image.mm_per_pixel = 0.5;
    return image;
}

// A dark disc on a light ground, with grain.
Image disc() {
    Chance chance(5);
    return on_page(pictures::drawn(
        480, 320, [&](int x, int y) { return (std::hypot(x - 200, y - 150) < 90 ? 60 : 190) + 4 * chance.normal(); }));
}

TEST_P(TrustBy, IsHighForAClearDiscAndLowForLeaves) {
    const auto clear = trust(disc()), busy = trust(on_page(pictures::leaves()));
    ASSERT_TRUE(clear && busy);
    EXPECT_GT(clear->agreement(), 0.8);
    EXPECT_LT(busy->agreement(), 0.56);
    EXPECT_FALSE(trust(on_page(pictures::drawn(480, 320, [](int, int) { return 128; })))) << "nothing is drawn";
}

TEST_P(TrustBy, IsNotToldOfWhatAPersonChose) {
    const std::string box = "subject=15%,10%-70%,85%";
    EXPECT_FALSE(trust(disc(), box));
    EXPECT_FALSE(trust(disc(), "leave=80%,80%-90%,90%"));
    EXPECT_FALSE(trust(disc(), "inner=0.2")) << "it was fitted to pages without";
    EXPECT_TRUE(trust(disc()));
}

INSTANTIATE_TEST_SUITE_P(Maps, TrustBy, testing::Values("learned", "plain"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace tactics::page_trust_test
