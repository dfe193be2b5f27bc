// SPDX-License-Identifier: Apache-2.0
// Taking borders out, beside a twin that looks at all of them again each time.
#include "filters/part_borders.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "filters/arc_worth.h"
#include "tests/filters/pictures.h"

namespace tactics::part_borders_test {
namespace {

struct Case {
    RegionTree tree;
    std::vector<double> gain, length;
    Parts faces;
};

Case case_of(std::uint64_t seed) {
    pictures::Chance chance(seed);
    Image image = pictures::leaves();
    image.mm_per_pixel = 0.5;
    Case one{std::get<RegionTree>(pictures::filtered("nest map=plain", image)), {}, {}, {}};
    for (const RegionArc& arc : one.tree.arcs) {
        one.length.push_back(steps_of(arc));
        one.gain.push_back(one.length.back() * (chance.unit() - 0.5));
    }
    one.faces.part.resize(one.tree.faces());
    std::iota(one.faces.part.begin(), one.faces.part.end(), 0u);
    return one;
}

using Ends = std::pair<std::uint32_t, std::uint32_t>;
struct Sum {
    double gain = 0, length = 0;
};

std::map<Ends, Sum> borders_of(const Case& one, const Parts& parts) {
    std::map<Ends, Sum> borders;
    for (std::size_t i = 0; i < one.tree.arcs.size(); ++i) {
        const auto ends = std::minmax(parts.part[one.tree.arcs[i].faces[0]], parts.part[one.tree.arcs[i].faces[1]]);
        if (ends.first == ends.second) continue;
        borders[ends].gain += one.gain[i];
        borders[ends].length += one.length[i];
    }
    return borders;
}

void take_out(Parts& parts, const Ends& ends) {
    for (std::uint32_t& part : parts.part)
        if (part == ends.second) part = ends.first;
}

TEST(PartBorders, TakesOutWhatLosesAsATwinDoes) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Case one = case_of(seed);
        PartBorders borders(one.tree, one.faces, one.gain, one.length);
        borders.take_out_losing(1e-6);
        Parts twin = one.faces;
        for (;;) {
            const auto all = borders_of(one, twin);
            const auto worst = std::min_element(all.begin(), all.end(),
                                                [](const auto& a, const auto& b) { return a.second.gain < b.second.gain; });
            if (worst == all.end() || worst->second.gain >= -1e-6) break;
            take_out(twin, worst->first);
        }
        EXPECT_EQ(borders.parts().part, twin.part) << seed;
        EXPECT_NEAR(borders.drawn(), length_of(one.tree, twin), 1e-6);
    }
}

TEST(PartBorders, KeepsToABudgetByWhatGainsLeastForItsLength) {
    const Case one = case_of(4);
    PartBorders borders(one.tree, one.faces, one.gain, one.length);
    const double all = borders.drawn();
    for (const double share : {0.5, 0.2}) {
        borders.take_out_until(share * all);
        EXPECT_LE(borders.drawn(), share * all);
        EXPECT_NEAR(borders.drawn(), length_of(one.tree, borders.parts()), 1e-6);
    }
    Parts twin = one.faces;
    while (length_of(one.tree, twin) > 0.2 * all) {
        const auto left = borders_of(one, twin);
        take_out(twin, std::min_element(left.begin(), left.end(), [](const auto& a, const auto& b) {
                           return a.second.gain / a.second.length < b.second.gain / b.second.length;
                       })->first);
    }
    EXPECT_EQ(borders.parts().part, twin.part);
    borders.take_out_until(0);
    EXPECT_EQ(borders.drawn(), 0);
}

}  // namespace
}  // namespace tactics::part_borders_test
