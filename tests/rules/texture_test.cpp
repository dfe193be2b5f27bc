// SPDX-License-Identifier: Apache-2.0
// Marks of a texture are one thing: no rule about lines is broken by them, and a line near them is seen.
#include <gtest/gtest.h>

#include "tactics/layout/pattern.h"
#include "tests/rules/pages.h"

namespace tactics::texture_test {
namespace {

using namespace tests;

Page textured(int texture, const std::string& medium = "swell") {
    Page page = blank_page();
    page.textured.push_back({{rectangle(20, 20, 100, 100)}, Role::line, texture});
    draw_patterns(page, find_medium(medium, "test"));
    return page;
}

TEST(TextureRules, APatternAloneBreaksNoRule) {
    for (const std::string medium : {"swell", "thermoform", "embosser"})
        for (int texture = 1; texture <= 5; ++texture) {
            const Page page = textured(texture, medium);
            for (const Verdict& verdict : check_page(page, demands_of(find_medium(medium, "test"))))
                EXPECT_TRUE(verdict.findings.places.empty()) << medium << " " << texture << " " << verdict.demand.rule->name
                                                             << ": " << verdict.findings.places[0].message.english();
        }
}

// The same marks, no longer said to be a pattern, break rules: it is the role that spares them.
TEST(TextureRules, TheSameMarksAsLinesDo) {
    for (const int texture : {2, 4, 5}) {  // the marks of the others stand apart
        Page page = textured(texture);
        for (PageStroke& stroke : page.strokes) stroke.role = Role::line;
        EXPECT_FALSE(findings_of(page, "gap").places.empty()) << texture;
    }
}

TEST(TextureRules, ALineThroughATextureIsSeenOnce) {
    for (int texture = 1; texture <= 5; ++texture) {
        Page page = textured(texture);
        add_line(page, {{10, 64.9}, {180, 72.7}});
        const Findings found = findings_of(page, "texture-clearance");
        ASSERT_EQ(found.places.size(), 1u) << texture;
        EXPECT_EQ(found.places[0].measured, 0);
        EXPECT_TRUE(findings_of(page, "gap").places.empty());
        EXPECT_TRUE(findings_of(page, "crossings").places.empty());
    }
}

TEST(TextureRules, AnAreaWithoutRoomForItsTextureIsTold) {
    Page page = blank_page();
    page.textured.push_back({{rectangle(20, 20, 3, 60)}, Role::line, 2});
    page.textured.push_back({{rectangle(60, 20, 60, 60)}, Role::line, 2});
    draw_patterns(page, find_medium("swell", "test"));
    const Findings found = findings_of(page, "texture-size");
    ASSERT_EQ(found.places.size(), 1u);
    EXPECT_EQ(found.places[0].measured, 0);
    EXPECT_EQ(found.places[0].message.english(), "an area without room for its texture, level lines");
}

}  // namespace
}  // namespace tactics::texture_test
