// SPDX-License-Identifier: Apache-2.0
// Letters drawn as shapes, read by the outlines of fonts: what is written as cairo writes it comes back as it was.
#include "tactics/job/letter_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tactics/job/letter_picture.h"
#include "tactics/readers/svg/svg.h"
#include "tactics/text/utf8.h"

namespace tactics::letter_shapes_test {
namespace {

std::vector<char32_t> codes_in(std::string_view text) {
    std::vector<char32_t> codes;
    while (!text.empty()) codes.push_back(take_letter(text));
    return codes;
}

std::map<char32_t, Letter> letters_for(const std::string& text) {
    Page page;
    PrintLine line;
    line.text = text;
    page.print.push_back(line);
    return letters_of(page);
}

// An outline at that size, turned to the left by that many degrees.
std::string path_of(const Letter& letter, double size, double degrees) {
    const double c = std::cos(degrees * 3.14159265358979 / 180), s = std::sin(degrees * 3.14159265358979 / 180);
    std::ostringstream d;
    for (const OutlineStep& step : letter.outline) {
        const int corners = step.kind == OutlineStep::Kind::curve ? 3 : 1;
        d << (step.kind == OutlineStep::Kind::move ? " M" : corners == 3 ? " C" : " L");
        for (int i = 0; i < corners; ++i) {
            const double x = step.corners[i].x * size / 1000, y = -step.corners[i].y * size / 1000;
            d << ' ' << c * x + s * y << ' ' << c * y - s * x;
        }
    }
    return d.str();
}

// As cairo does it: a symbol for each letter, of turned lines turned ones.
std::string line_of(const std::string& text, double size, double degrees, int font, Point from = {80, 80}) {
    const auto letters = letters_for(text);
    std::map<char32_t, int> numbers;
    std::ostringstream defs, uses;
    double at = 0;
    const double c = std::cos(degrees * 3.14159265358979 / 180), s = std::sin(degrees * 3.14159265358979 / 180);
    for (const char32_t code : codes_in(text)) {
        const auto [number, fresh] = numbers.try_emplace(code, static_cast<int>(numbers.size()));
        const std::string name = "glyph" + std::to_string(font) + "-" + std::to_string(number->second);
        const Letter& letter = letters.at(code);
        if (fresh) defs << "<symbol id='" << name << "'><path d='" << path_of(letter, size, degrees) << "'/></symbol>";
        uses << "<use href='#" << name << "' x='" << from.x + c * at << "' y='" << from.y - s * at << "'/>";
        at += letter.advance * size / 1000;
    }
    return "<defs>" + defs.str() + "</defs><g>" + uses.str() + "</g>";
}

FoundPage figure(const std::string& body, const Fonts& fonts = each_font) {
    return read_svg(
        "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='150mm' viewBox='0 0 200 150'>" + body + "</svg>",
        "figure.svg", 0, std::nullopt, SvgPurpose::figure, [&](FoundPage& page) { read_letter_shapes(page, fonts); });
}

bool has_font() { return !letters_for("R").at('R').outline.empty(); }

TEST(LetterShapes, SayWhatWasWritten) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    for (const std::string text : {"Mean of 1234567890 l/I, A-B: \"x_1\"", "R = 10 Ω, −5 °C, µm", "Größe"}) {
        const FoundPage page = figure(line_of(text, 12.3, 0, 0));
        ASSERT_EQ(page.words.size(), 1u);
        EXPECT_EQ(page.words[0].text, text);
        EXPECT_TRUE(page.page.strokes.empty());
        EXPECT_TRUE(page.page.areas.empty()) << "letters are no lines";
        EXPECT_FALSE(page.words[0].upwards);
        EXPECT_NEAR(page.words[0].middle.y, 76, 2);
    }
}

TEST(LetterShapes, OfTurnedLinesAreReadAlongThem) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const FoundPage page = figure(line_of("Speed in m/s", 10, 90, 0) + line_of("Mill Road", 10, 30, 1));
    ASSERT_EQ(page.words.size(), 2u);
    EXPECT_EQ(page.words[0].text, "Speed in m/s");
    EXPECT_TRUE(page.words[0].upwards);
    EXPECT_EQ(page.words[1].text, "Mill Road");
}

// As pdftocairo has what LibreOffice turned: a group for each letter. Figures in a column have it, too, and are not turned.
TEST(LetterShapes, OfTurnedLinesMayEachHaveAGroup) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const auto apart = [](std::string body) {
        for (std::size_t at = 0; (at = body.find("<use", at)) != std::string::npos; at += 9) body.insert(at, "</g><g>");
        return body;
    };
    for (const std::string text : {"Mass (kg)", "mm"}) {
        const FoundPage page = figure(apart(line_of(text, 10, 90, 0)));
        ASSERT_EQ(page.words.size(), 1u) << text;
        EXPECT_EQ(page.words[0].text, text);
        EXPECT_TRUE(page.words[0].upwards);
    }
    const std::string letters = line_of("247", 10, 0, 3);
    std::string column = letters.substr(0, letters.find("</defs>") + 7);
    for (int row = 0; row < 3; ++row)
        column += "<g><use href='#glyph3-" + std::to_string(row) + "' x='80' y='" + std::to_string(40 + 11 * row) + "'/></g>";
    const FoundPage page = figure(column);
    ASSERT_EQ(page.words.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(page.words[i].text, std::string(1, "247"[i]));
}

// TeX takes signs and indices of a formula from fonts that have nothing else in the figure.
TEST(LetterShapes, OfAFormulaAreOneThoughTheyAreOfManyFonts) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const auto wide = [](const std::string& text, double size) {
        double all = 0;
        for (const auto& [code, letter] : letters_for(text)) all += letter.advance * size / 1000;
        return all;
    };
    const auto texts = [](const std::string& body) {
        std::vector<std::string> all;
        for (const FoundWords& words : figure(body).words) all.push_back(words.text);
        return all;
    };
    using Texts = std::vector<std::string>;
    const std::string known = line_of("Rates 4711", 10, 0, 1, {20, 30});
    const double minus = wide("\u2212", 10), r = wide("R", 10);
    EXPECT_EQ(texts(known + line_of("\u2212", 10, 0, 2, {80, 60}) + line_of("471", 10, 0, 4, {80 + minus, 60})),
              (Texts{"Rates 4711", "\u2212471"}));
    const std::string index = line_of("R", 10, 0, 1, {80, 60}) + line_of("1", 7, 0, 3, {80 + r, 61.5});
    EXPECT_EQ(texts(known + index), (Texts{"Rates 4711", "R\u2081"}));
    const std::string power = line_of("R", 10, 0, 1, {80, 60}) + line_of("x", 7, 0, 3, {80 + r, 56});
    EXPECT_EQ(texts(known + power), (Texts{"Rates 4711", "R^x"}));
    const std::string rest = line_of("=", 10, 0, 2, {80 + r + wide("1", 7) + 2.5, 60});
    EXPECT_EQ(texts(known + index + rest), (Texts{"Rates 4711", "R\u2081 ="}));
    // As large as the other and off its line, nobody knows what it is; farther off it is something else.
    EXPECT_EQ(texts(known + line_of("R", 10, 0, 1, {80, 60}) + line_of("1", 10, 0, 3, {80 + r, 62.5})),
              (Texts{"Rates 4711", ""}));
    EXPECT_EQ(texts(known + line_of("R", 10, 0, 1, {80, 60}) + line_of("471", 10, 0, 4, {80 + r, 70})),
              (Texts{"Rates 4711", "R", "471"}));
}

TEST(LetterShapes, ThatNoFontHasStayUnread) {
    const std::string shape = "<defs><symbol id='glyph0-1'><path d='M0,0 L4,-9 L6,-2 L9,-8 L7,1 Z'/></symbol></defs>";
    const FoundPage page = figure(shape + "<g><use href='#glyph0-1' x='20' y='30'/></g>");
    ASSERT_EQ(page.words.size(), 1u);
    EXPECT_EQ(page.words[0].text, "");
    EXPECT_NEAR(page.words[0].middle.x, 24.5, 1e-6);
    EXPECT_NEAR(page.words[0].middle.y, 26, 1e-6);
    EXPECT_TRUE(page.page.areas.empty());
}

// Of two fonts with different shapes of a, the file's own is chosen; a font whose o has no hole has signs in place of letters.
TEST(LetterShapes, AreNotTakenFromFontsOfSigns) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const Fonts shifted = [](const auto& goes_on) {
        each_font([&](const FontLetters& font) {
            FontLetters other;
            other.plain = [font](const std::vector<char32_t>& codes, Hinting hinting, double pixels) {
                std::vector<char32_t> next;
                for (const char32_t code : codes) next.push_back(code + 1);
                std::map<char32_t, Letter> out;
                for (auto& [code, letter] : font.plain(next, hinting, pixels)) out[code - 1] = letter;
                return out;
            };
            return goes_on(other);
        });
    };
    const FoundPage page = figure(line_of("Signal", 12, 0, 0), shifted);
    ASSERT_EQ(page.words.size(), 1u);
    EXPECT_EQ(page.words[0].text, "");
}

// Without a font they are read as a picture; a word that is not read completely stays unread.
TEST(LetterShapes, ThatNoFontHasAreReadAsPrint) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const Fonts none = [](const auto&) {};
    FoundPage page = figure(line_of("Rainfall in Lisbon", 12, 0, 0), none);
    ASSERT_EQ(page.words.size(), 1u);
    ASSERT_EQ(page.words[0].text, "");
    if (const std::string trouble = read_letter_picture(page, "en").english(); !trouble.empty()) GTEST_SKIP() << trouble;
    EXPECT_EQ(page.words[0].text, "Rainfall in Lisbon");
    EXPECT_LT(page.words[0].sureness, 100);
    FoundPage stepped = figure(line_of("Rainfall in Lisbon", 12, 0, 0), none);
    FoundWords& words = stepped.words[0];
    for (std::size_t i = 0; i < words.letters.size(); i += 2) words.letters[i].up = words.height / words.unit;
    read_letter_picture(stepped, "en");
    EXPECT_NE(words.text, "Rainfall in Lisbon") << "letters off the line are drawn there";
    FoundPage doubtful = figure(line_of("cos x", 12, 0, 0), none);
    read_letter_picture(doubtful, "en");
    EXPECT_EQ(doubtful.words[0].text, "") << "or COS X";
    FoundPage again = figure(line_of("Rainfall in Lisbon", 12, 0, 0), none);
    EXPECT_NE(read_letter_picture(again, "en", "no-such-program").english(), "");
    EXPECT_EQ(again.words[0].text, "");
}

TEST(LetterShapes, NeedMoreThanARectangle) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const FoundPage page = figure(line_of("-", 12, 0, 0));  // or an l, lying; or an underline
    ASSERT_EQ(page.words.size(), 1u);
    EXPECT_EQ(page.words[0].text, "");
}

}  // namespace
}  // namespace tactics::letter_shapes_test
