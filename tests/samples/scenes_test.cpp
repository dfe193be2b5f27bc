// SPDX-License-Identifier: Apache-2.0
// The samples are the same pictures every time, and pictures that a recipe has work with.
#include "samples/draw/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <string>
#include <thread>

#include "tests/golden/golden.h"

namespace tactics::samples {
void PrintTo(const Scene& scene, std::ostream* out) { *out << scene.name; }  // GoogleTest finds it by its name
}  // namespace tactics::samples

namespace tactics::scenes_test {
namespace {

class SampleScene : public testing::TestWithParam<samples::Scene> {};

// A compiler may round the noise of a pixel another way here and there; the picture stays.
TEST_P(SampleScene, LooksAsItDid) {
    golden::expect_golden("samples/" + std::string(GetParam().name), samples::draw_scene(GetParam().name, 96), 0.02);
}

TEST_P(SampleScene, IsThePictureItIsAskedFor) {
    for (const int size : {16, 41}) {
        const Image image = samples::draw_scene(GetParam().name, size);
        EXPECT_EQ(std::max(image.width, image.height), size);
        EXPECT_EQ(image.channels, 3);
        EXPECT_EQ(image.pixels.size(), image.row_bytes() * static_cast<std::size_t>(image.height));
    }
}

TEST_P(SampleScene, IsTheSameOnEveryThread) {
    const Image here = samples::draw_scene(GetParam().name, 32);
    Image there;
    std::thread([&] { there = samples::draw_scene(GetParam().name, 32); }).join();
    EXPECT_EQ(here.pixels, there.pixels);
}

// Not clip art: a photograph has many greys, soft shade and noise, so few pixels equal their neighbour.
TEST_P(SampleScene, HasTheGreysOfItsKind) {
    const Image grey = to_grey(samples::draw_scene(GetParam().name, 200));
    const std::set<std::uint8_t> greys(grey.pixels.begin(), grey.pixels.end());
    std::size_t equal = 0;
    for (std::size_t i = 1; i < grey.pixels.size(); ++i) equal += grey.pixels[i] == grey.pixels[i - 1] ? 1 : 0;
    const double share = static_cast<double>(equal) / static_cast<double>(grey.pixels.size());
    if (GetParam().photograph) {
        EXPECT_GT(greys.size(), 150u);
        EXPECT_LT(share, 0.2);
    } else {
        EXPECT_GT(share, 0.5);
    }
}

std::string test_name(const testing::TestParamInfo<samples::Scene>& tested) {
    std::string name(tested.param.name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleScene, testing::ValuesIn(samples::scenes().begin(), samples::scenes().end()), test_name);

TEST(Samples, UnknownNameIsAFaultOfTheCaller) { EXPECT_THROW(samples::draw_scene("no-such-scene", 64), std::logic_error); }

}  // namespace
}  // namespace tactics::scenes_test
