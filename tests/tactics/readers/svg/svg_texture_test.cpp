// SPDX-License-Identifier: Apache-2.0
// Textures written as SVG and read back: areas, marks and what they are for.
#include <gtest/gtest.h>

#include "print/format.h"
#include "tactics/layout/pattern.h"
#include "tactics/readers/svg/svg.h"
#include "tests/rules/pages.h"

namespace tactics::svg_texture_test {
namespace {

using namespace tests;

TEST(SvgTexture, ComesBackAsItWas) {
    for (const std::string medium : {"swell", "embosser"}) {
        Page page = blank_page();
        for (int texture = 1; texture <= 5; ++texture)
            page.textured.push_back(
                {{rectangle(10, 40.0 * (texture - 1), 150, 38), rectangle(60, 40.0 * (texture - 1) + 12, 20, 12)},
                 Role::line,
                 texture});
        add_line(page, {{170, 10}, {170, 190}});
        draw_patterns(page, find_medium(medium, "test"));
        const Format& svg = *find_format("svg");
        const FoundPage found = read_svg(svg.encode(page, Settings(svg.options)), "page.svg", 0, std::nullopt);
        EXPECT_TRUE(found.page.braille.empty()) << "a pattern's dots are no braille";
        // A file has one layer after the other.
        ASSERT_EQ(found.page.strokes.size(), page.strokes.size());
        std::stable_partition(page.strokes.begin(), page.strokes.end(),
                              [](const PageStroke& stroke) { return stroke.role == Role::pattern; });
        for (std::size_t i = 0; i < page.strokes.size(); ++i) {
            const PageStroke &was = page.strokes[i], &is = found.page.strokes[i];
            EXPECT_EQ(is.role, was.role);
            EXPECT_NEAR(is.width, was.width, 0.006);
            ASSERT_EQ(is.points.size(), was.points.size());
            for (std::size_t k = 0; k < was.points.size(); ++k) EXPECT_LT(distance(is.points[k], was.points[k]), 0.008);
        }
        ASSERT_EQ(found.page.textured.size(), 5u);
        EXPECT_TRUE(found.page.areas.empty());
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_EQ(found.page.textured[i].texture, page.textured[i].texture);
            ASSERT_EQ(found.page.textured[i].rings.size(), 2u);
            EXPECT_EQ(found.page.textured[i].rings[1].size(), 4u);
        }
    }
}

TEST(SvgTexture, AClassOfAnotherMakerIsNone) {
    const auto read = [](const std::string& name) {
        return read_svg(
                   "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'><path class='" +
                       name + "' d='M10 10h50v50h-50z'/></svg>",
                   "page.svg", 0, std::nullopt)
            .page;
    };
    EXPECT_EQ(read("tactics-texture-3").textured.size(), 1u);
    for (const std::string name :
         {"texture-3", "tactics-texture-", "tactics-texture-x", "tactics-texture-31", "tactics-texture-0"}) {
        EXPECT_TRUE(read(name).textured.empty()) << name;
        EXPECT_EQ(read(name).areas.size(), 1u) << name;
    }
}

}  // namespace
}  // namespace tactics::svg_texture_test
