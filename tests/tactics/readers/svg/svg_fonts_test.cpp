// SPDX-License-Identifier: Apache-2.0
// Words of texts in a font that the file brings along, as dvisvgm writes those of TeX.
#include "tactics/readers/svg/svg_fonts.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tactics/readers/svg/svg.h"

namespace tactics::svg_fonts_test {
namespace {

// Figures and most letters are half an em wide, a W is a whole one.
constexpr const char* kFont =
    "<defs><font horiz-adv-x=\"500\"><font-face font-family=\"cmr10\" units-per-em=\"1000\"/>"
    "<glyph unicode=\"W\" horiz-adv-x=\"1000\"/><glyph unicode=\"V\" horiz-adv-x=\"750\"/><glyph unicode=\"a\"/><glyph "
    "unicode=\"s\"/>"
    "<glyph unicode=\"h\"/><glyph unicode=\"R\"/><glyph unicode=\"x\"/><glyph unicode=\"0\"/><glyph unicode=\"1\"/>"
    "<glyph unicode=\"2\"/><glyph unicode=\"9\"/><glyph unicode=\"&#x25E6;\"/></font></defs>"
    "<style>.f{font-family:cmr10;font-size:10px} .s{font-family:cmr10;font-size:7px} "
    ".o{font-family:other;font-size:10px}</style>";

std::vector<std::string> texts_in(const std::string& texts, const FontOpener& open = {}, const std::string& font = kFont) {
    const std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"400\" height=\"300\">" + font +
                            "<path d=\"M10 10H300V200\" stroke=\"black\" fill=\"none\"/>" + texts + "</svg>";
    std::vector<std::string> all;
    for (const FoundWords& words : read_svg(svg, "test.svg", 0, std::nullopt, SvgPurpose::figure, {}, open).words)
        all.push_back(words.text);
    return all;
}

using Texts = std::vector<std::string>;

TEST(SvgFonts, TellKerningFromSpaces) {
    EXPECT_EQ(texts_in("<text class=\"f\" x=\"50\" y=\"50\">W<tspan x=\"59.2\">ash</tspan></text>"), Texts{"Wash"});
    EXPECT_EQ(texts_in("<text class=\"f\" x=\"50\" y=\"50\">9<tspan x=\"57.5\">V</tspan></text>"), Texts{"9 V"});
    EXPECT_EQ(texts_in("<text class=\"f\" x=\"50\" y=\"50\">a<tspan x=\"58\">W<tspan x=\"71\">ash</tspan></tspan></text>"),
              Texts{"a W ash"});
    const std::string lacking = "<text class=\"o\" x=\"50\" y=\"50\">9<tspan x=\"57.5\">V</tspan></text>";
    EXPECT_EQ(texts_in(lacking), Texts{"9V"}) << "a guess, in another font";
}

TEST(SvgFonts, TextsGoOnWhereOthersEnd) {
    const auto two = [](const std::string& second) { return texts_in("<text class=\"f\" x=\"50\" y=\"50\">R</text>" + second); };
    EXPECT_EQ(two("<text class=\"s\" x=\"55\" y=\"51.6\">1</text>"), Texts{"R1"});
    EXPECT_EQ(two("<text class=\"s\" x=\"55\" y=\"46\">2</text>"), Texts{"R²"});
    EXPECT_EQ(two("<text class=\"s\" x=\"55\" y=\"46\">\u25E6</text>"), Texts{"R°"});
    EXPECT_EQ(two("<text class=\"s\" x=\"55\" y=\"51.6\">1</text><text class=\"f\" x=\"59\" y=\"50\">x</text>"), Texts{"R1x"});
    EXPECT_EQ(two("<text class=\"f\" x=\"55\" y=\"50\">0</text>"), Texts{"R0"});
    EXPECT_EQ(two("<text class=\"f\" x=\"58.3\" y=\"50\">0</text>"), Texts{"R 0"});
    EXPECT_EQ(two("<text class=\"f\" x=\"75\" y=\"50\">0</text>"), (Texts{"R", "0"})) << "farther off";
    EXPECT_EQ(two("<text class=\"f\" x=\"55\" y=\"60\">0</text>"), (Texts{"R", "0"})) << "below";
    EXPECT_EQ(two("<text class=\"s\" x=\"55\" y=\"60\">1</text>"), (Texts{"R", "1"})) << "too low for an index";
    EXPECT_EQ(two("<text class=\"o\" x=\"55\" y=\"50\">0</text>"), (Texts{"R", "0"})) << "in a font that is not known";
    EXPECT_EQ(texts_in("<g transform=\"translate(50 150) rotate(-90)\"><text class=\"f\" x=\"0\" y=\"0\">1</text>"
                       "<text class=\"f\" x=\"5\" y=\"0\">0</text></g>"),
              Texts{"10"});
}

TEST(SvgFonts, OfStyleSheetsAreOpenedOnce) {
    int opened = 0;
    const FontOpener open = [&](const std::string& file) -> LetterWidths {
        ++opened;
        EXPECT_EQ(file, "font file");
        return [](char32_t) { return std::optional(0.5); };
    };
    const std::string face =
        "<style>@font-face{font-family:'ec-lmr9';src:url(data:application/x-font-woff2;base64,Zm9udCBmaWxl) format('woff2');}"
        ".f{font-family:ec-lmr9;font-size:10px}</style>";
    const std::string two =
        "<text class=\"f\" x=\"50\" y=\"50\">9<tspan x=\"57\">V</tspan></text>"
        "<text class=\"f\" x=\"50\" y=\"90\">4<tspan x=\"55\">7</tspan></text>";
    EXPECT_EQ(texts_in(two, open, face), (Texts{"9 V", "47"}));
    EXPECT_EQ(opened, 1);
    EXPECT_EQ(texts_in(
                  two, [](const std::string&) { return LetterWidths(); }, face),
              (Texts{"9V", "47"}))
        << "no font file";
    EXPECT_EQ(texts_in(two, open, "<style>@font-face{font-family:x;src:url(</style>").size(), 2u) << "cut short";
}

}  // namespace
}  // namespace tactics::svg_fonts_test
