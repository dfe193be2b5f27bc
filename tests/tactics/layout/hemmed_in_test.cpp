// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "tactics/geometry/course.h"
#include "tactics/layout/lay_out.h"

namespace tactics::hemmed_in_test {
namespace {

// A thing whose middle lies among lines is named at another place of its border; without a region there is no other place.
TEST(Naming, AThingThatIsHemmedInIsNamedElsewhereOnItsBorder) {
    Sheet sheet;
    sheet.paper = find_paper("a4", "test");
    sheet.medium = &find_medium("swell", "test");
    Drawing drawing;
    drawing.width = 180;
    drawing.height = 240;
    for (int i = 0; i < 40; ++i) {  // lines that no lead line may come near, let alone cross, round the middle
        const double y = 20 + 2.0 * i;
        drawing.strokes.push_back({{{10, y}, {120, y}}});
        drawing.strokes.push_back({{{10 + 2.0 * i, 20}, {10 + 2.0 * i, 100}}});
    }
    drawing.strokes.push_back({{{60, 60}, {150, 60}, {150, 160}, {60, 160}}, true});
    drawing.names.push_back({{70, 70}, "a long name that has no room beside any of these lines", "the model", 0, true});
    EXPECT_EQ(lay_out(drawing, sheet).left_out.size(), 1u);
    Region region;
    region.name = Phrase(drawing.names[0].text);
    region.rings = {{{60, 60}, {150, 60}, {150, 160}, {60, 160}}};
    region.at = {70, 70};
    drawing.regions.push_back(region);
    const Page page = lay_out(drawing, sheet);
    EXPECT_EQ(page.left_out.size(), 0u);
    ASSERT_EQ(page.names.size(), 1u);
    EXPECT_FALSE(page.names[0].key.empty());
    double off = 1e9;  // the place that is named, from the border
    const auto& ring = page.regions[0].rings[0];
    for (std::size_t i = 0; i < ring.size(); ++i)
        off = std::min(off, distance_to_segment(page.names[0].thing, ring[i], ring[(i + 1) % ring.size()]));
    EXPECT_LT(off, 0.01);
    // What has another name is another thing; only a name that must be there goes to its border, before there is no page.
    drawing.regions[0].name = Phrase("thing");
    EXPECT_EQ(lay_out(drawing, sheet).left_out.size(), 1u);
    drawing.names[0].optional = false;
    EXPECT_EQ(lay_out(drawing, sheet).names.size(), 1u);
}

}  // namespace
}  // namespace tactics::hemmed_in_test
