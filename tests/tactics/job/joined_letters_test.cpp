// SPDX-License-Identifier: Apache-2.0
// Words whose letters touch in their font, as a V and a P with serifs do.
#include <gtest/gtest.h>

#include <algorithm>

#include "print/format.h"
#include "tactics/job/print_fonts.h"
#include "tactics/lettering/lettering.h"
#include "tactics/readers/read.h"

namespace tactics::joined_letters_test {
namespace {

double right_of(const FontShape& shape) {
    double right = 0;
    for (const auto& ring : shape.rings)
        for (const Point& p : ring) right = std::max(right, p.x);
    return right;
}
double left_of(const FontShape& shape) {
    double left = 1;
    for (const auto& ring : shape.rings)
        for (const Point& p : ring) left = std::min(left, p.x);
    return left;
}

// Of the first font in which these two touch; empty if there is none.
FontShapes touching(char32_t one, char32_t other) {
    constexpr std::u32string_view kLetters = U"VPFlowchartRin";
    FontShapes found;
    each_print_font({kLetters.begin(), kLetters.end()}, [&](const PrintFont& font) {
        const FontShapes& shapes = font.shapes;
        const bool all = std::all_of(kLetters.begin(), kLetters.end(), [&](char32_t code) { return shapes.contains(code); });
        if (!all || shapes.at(one).advance - right_of(shapes.at(one)) + left_of(shapes.at(other)) > 0.01) return true;
        found = shapes;
        return false;
    });
    return found;
}

void write(Page& page, const FontShapes& font, Point at, double size, std::u32string_view text) {
    for (const char32_t code : text) {
        if (code != U' ') {
            std::vector<std::vector<Point>> rings = font.at(code).rings;
            for (auto& ring : rings)
                for (Point& p : ring) p = {at.x + size * p.x, at.y - size * p.y};
            page.areas.push_back({std::move(rings)});
        }
        at.x += size * (code == U' ' ? 0.3 : font.at(code).advance);
    }
}

TEST(JoinedLetters, MayBeAllThatAWordHas) {
    const FontShapes font = touching(U'V', U'P');
    if (font.empty()) GTEST_SKIP() << "no font here has letters that touch";
    Page page;
    page.width = 110;
    page.height = 70;
    write(page, font, {20, 14}, 5, U"Flow chart");
    write(page, font, {20, 55}, 5, U"Rain Flow");
    write(page, font, {60, 34}, 5, U"VP");
    const Format& png = *find_format("png");
    Settings settings(png.options);
    settings.set("dpi", "600", "test", "png");
    const std::string bytes = png.encode(page, settings);
    Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "page.png");
    const Lettering lettering = read_lettering(read_picture(source, {650, false}), "en", kSureEnough, each_print_font);
    std::vector<std::string> words;
    for (const PrintedWords& one : lettering.words)
        if (one.sure) words.push_back(one.text);
    EXPECT_NE(std::find(words.begin(), words.end(), "VP"), words.end());
}

}  // namespace
}  // namespace tactics::joined_letters_test
