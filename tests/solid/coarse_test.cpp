// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/coarse.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/solid/models.h"

namespace tactics::coarse_test {
namespace {

using namespace tests;

// A wavy surface, with so many triangles that it has to be made coarser.
Model wide_surface() {
    constexpr std::uint32_t kCount = 330;
    Model model;
    ModelObject& object = model.objects.emplace_back();
    object.name = "Sea";
    for (std::uint32_t y = 0; y < kCount; ++y)
        for (std::uint32_t x = 0; x < kCount; ++x) model.vertices.push_back({1.0 * x, 1.0 * y, 5.0 * ((x / 20 + y / 20) % 2)});
    for (std::uint32_t y = 0; y + 1 < kCount; ++y)
        for (std::uint32_t x = 0; x + 1 < kCount; ++x) {
            const std::uint32_t at = y * kCount + x;
            for (const auto& corners : {std::array{at, at + 1, at + kCount}, std::array{at + 1, at + kCount + 1, at + kCount}}) {
                model.faces.push_back({static_cast<std::uint32_t>(model.corners.size()), 3});
                model.corners.insert(model.corners.end(), corners.begin(), corners.end());
            }
        }
    object.count = static_cast<std::uint32_t>(model.faces.size());
    return model;
}

TEST(Coarse, NamesTheObjectsOfWhichNothingIsLeft) {
    Model model = wide_surface();
    add_box(model, "Boat", -1, {100, 100, 20}, {60, 20, 20});
    add_box(model, "Buoy", -1, {200.3, 200.3, 20}, {0.01, 0.01, 0.01});
    ASSERT_GT(corners_of(model), kMostWorkedCorners);
    std::vector<Phrase> notes;
    const Model made = coarse(model, notes);
    EXPECT_LE(corners_of(made), kMostWorkedCorners);
    const auto says = [&](const char* words) {
        return std::any_of(notes.begin(), notes.end(),
                           [&](const Phrase& note) { return note.english().find(words) != std::string::npos; });
    };
    EXPECT_TRUE(says("1 object is so small that none of its faces is left: Buoy"));
    EXPECT_FALSE(says("Boat"));
}

}  // namespace
}  // namespace tactics::coarse_test
