// SPDX-License-Identifier: Apache-2.0
#include "filters/components.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/filters/pictures.h"

namespace tactics::components_test {
namespace {

using namespace pictures;

// Numbers of the pieces by filling them one after the other; 0 is ground.
std::vector<int> flood(const Image& image, bool corners) {
    std::vector<int> label(image.pixels.size(), 0);
    int count = 0;
    for (int start = 0; start < static_cast<int>(image.pixels.size()); ++start) {
        if (image.pixels[static_cast<std::size_t>(start)] != 0 || label[static_cast<std::size_t>(start)] != 0) continue;
        ++count;
        std::vector<int> open{start};
        while (!open.empty()) {
            const int at = open.back();
            open.pop_back();
            if (label[static_cast<std::size_t>(at)] != 0) continue;
            label[static_cast<std::size_t>(at)] = count;
            const int x = at % image.width;
            const int y = at / image.width;
            for (int v = std::max(0, y - 1); v <= std::min(image.height - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(image.width - 1, x + 1); ++u)
                    if ((corners || u == x || v == y) && image.row(v)[u] == 0) open.push_back(v * image.width + u);
        }
    }
    return label;
}

TEST(Components, AreThoseThatFloodingFinds) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        Chance chance(seed);
        const Image image = random_ink(1 + chance.below(40), 1 + chance.below(30), seed, 20 + chance.below(70));
        for (const bool corners : {false, true}) {
            const auto expected = flood(image, corners);
            const Components found = find_components(image.width, image.height, corners ? Joined::by_corners : Joined::by_sides,
                                                     [&](std::size_t i) { return image.pixels[i] == 0; });
            std::vector<int> label(image.pixels.size(), 0);
            for (const auto& run : found.runs)
                for (int x = run.begin; x < run.end; ++x)
                    label[static_cast<std::size_t>(run.row * image.width + x)] = static_cast<int>(run.component) + 1;
            // Both number the pieces by their first pixel, row by row.
            EXPECT_EQ(label, expected) << "seed " << seed;
            const auto areas = found.areas(), extents = found.extents();
            ASSERT_EQ(areas.size(), found.count);
            ASSERT_EQ(extents.size(), found.count);
            for (std::size_t c = 0; c < areas.size(); ++c) {
                const int number = static_cast<int>(c) + 1;
                EXPECT_EQ(areas[c], static_cast<std::size_t>(std::count(expected.begin(), expected.end(), number)));
                std::set<int> columns, rows;
                for (int i = 0; i < static_cast<int>(expected.size()); ++i)
                    if (expected[static_cast<std::size_t>(i)] == number)
                        columns.insert(i % image.width), rows.insert(i / image.width);
                EXPECT_EQ(extents[c], std::max(columns.size(), rows.size()));  // nothing is missing between: it hangs together
            }
        }
    }
}

}  // namespace
}  // namespace tactics::components_test
