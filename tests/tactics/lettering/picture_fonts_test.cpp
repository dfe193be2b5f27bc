// SPDX-License-Identifier: Apache-2.0
// The fonts and sizes that a picture's print tells, and what lines say in them.
#include "tactics/lettering/picture_fonts.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tactics/lettering/form_words.h"
#include "tactics/lettering/meant_letters.h"
#include "tactics/lettering/read_line.h"
#include "tests/tactics/lettering/stroke_font.h"

namespace tactics::picture_fonts_test {
namespace {

using namespace stroke_font;

std::vector<FormWords> read_lines(const std::vector<Image>& images, const std::vector<OtherReading>& others,
                                  const PrintFont& font) {
    std::vector<InkStrip> strips;
    for (const Image& image : images) strips.emplace_back(image, line_in(image));
    return read_in_fonts(strips, others, [&](const auto&, const auto& goes_on) { goes_on(font); });
}

TEST(PictureFonts, AFormulaIsReadInTheFontOfTheWords) {
    const FontShapes plain = strokes(0.1, 0.5);
    FontShapes formula = plain;
    formula[U'L'] = {0.6, {box(0.4, 0, 0.5, 0.7), box(0.05, 0, 0.5, 0.1)}};  // another form of it
    const std::vector<Image> images{written(plain, U"1010", 30), written(formula, U"L", 30)};
    const auto text = [&](const PrintFont& font) { return read_lines(images, {{"1010", true}, {}}, font)[1].text; };
    EXPECT_EQ(text(PrintFont{plain}), "");
    EXPECT_EQ(text(PrintFont{plain, {}, {}, [&](const auto&) { return formula; }}), "L");
}

// Most lines of formulas have upright letters, too.
TEST(PictureFonts, ALineMayHaveLettersOfFormulasAndOthers) {
    const FontShapes plain = strokes(0.1, 0.5);
    FontShapes formula = plain;
    formula[U'L'] = {0.6, {box(0.4, 0, 0.5, 0.7), box(0.05, 0, 0.5, 0.1)}};
    formula[U'H'] = {0.7, {box(0.05, 0, 0.15, 0.7), box(0.5, 0, 0.6, 0.7), box(0.05, 0.6, 0.6, 0.7)}};
    FontShapes both = plain;
    both[U'L'] = formula[U'L'];
    const PrintFont font{plain, {}, {}, [&](const auto&) { return formula; }};
    const std::vector<FormWords> words =
        read_lines({written(plain, U"1010", 30), written(both, U"LH7", 30)}, {{"1010", true}, {}}, font);
    EXPECT_EQ(words[1].text, "LH7");
    EXPECT_TRUE(words[1].sized);
}

// The narrow font has an O like the 0 of the wide one; another reader takes that for it.
TEST(PictureFonts, AFigureThatIsReadAsALetterTellsItsFont) {
    const FontShapes wide = strokes(0.1, 0.5);
    FontShapes narrow = wide;
    narrow[U'H'] = {0.7, {box(0.05, 0, 0.15, 0.7), box(0.5, 0, 0.6, 0.7), box(0.05, 0.28, 0.6, 0.38)}};
    narrow[U'O'] = wide.at(U'0');
    std::vector<InkStrip> strips;
    const Image image = written(wide, U"H0", 30);
    strips.emplace_back(image, line_in(image));
    const std::vector<OtherReading> others{{"HO", true}};
    const auto words = read_in_fonts(strips, others, [&](const auto&, const auto& goes_on) {
        if (goes_on(PrintFont{narrow})) goes_on(PrintFont{wide});
    });
    EXPECT_EQ(words[0].text, "H0");
}

// A figure of geometry may have no words at all.
TEST(PictureFonts, AFormulaTellsItsFontWhereNoWordDoes) {
    const FontShapes plain = strokes(0.1, 0.5);
    FontShapes formula = plain;
    formula[U'L'] = {0.6, {box(0.4, 0, 0.5, 0.7), box(0.05, 0, 0.5, 0.1)}};
    const std::vector<Image> images{written(formula, U"TL7Hn", 30), written(formula, U"L", 30)};
    const auto text = [&](const PrintFont& font, const std::string& other) {
        return read_lines(images, {{other, false}, {}}, font)[1].text;
    };
    const PrintFont font{plain, {}, {}, [&](const auto&) { return formula; }};
    EXPECT_EQ(text(font, "TJ7Hn"), "L");
    EXPECT_EQ(text(font, "7.11"), "") << "no letters were read";
    EXPECT_EQ(text(PrintFont{plain}, "TJ7Hn"), "");
}

TEST(FormText, KnowsTheSpacesOfFormulas) {
    FormFont font(strokes(0.1, 0.5));
    const auto is_thin = [&](double gap) {  // em
        FormReading reading;
        reading.em = 30;
        for (const double left : {20.0, 20 + 30 * (0.6 + gap)}) {
            FormLetter letter;
            letter.code = U'L';
            letter.box = {left, 0, left + 13.5, 21};
            reading.letters.push_back(letter);
        }
        return has_thin_spaces(reading, font);
    };
    EXPECT_FALSE(is_thin(0));
    EXPECT_TRUE(is_thin(0.167));
    EXPECT_FALSE(is_thin(0.28));
}

// A 1 leaves much room beside it.
TEST(PictureFonts, TheGapsOfAFigureAreThoseOfItsFont) {
    FontShapes font = strokes(0.1, 0.5);
    font[U'1'] = {0.6, {box(0.1, 0, 0.2, 0.7), box(0.04, 0.5, 0.2, 0.56)}};
    FontShapes printed = strokes(0.13, 0.5);  // another font, of its kind
    printed[U'1'] = font[U'1'];
    const auto words = read_lines({written(printed, U"1000", 30), written(font, U"LTHH", 30)}, {{"1 000", true}, {"LTHH", true}},
                                  PrintFont{font});
    EXPECT_LT(words[0].reading.mean, 0.92);
    EXPECT_EQ(words[0].text, "1000");
}

// Fonts have lowered figures as letters of their own, too.
TEST(PictureFonts, ALoweredFigureFollowsALetterOfItsSize) {
    FontShapes font = strokes(0.1, 0.5);
    font[0x2081] = {0.3, {box(0.1, -0.15, 0.18, 0.27), box(0.04, -0.15, 0.24, -0.09)}};
    const auto text = [&](std::u32string_view second, double em) {
        return read_lines({written(font, U"1010", em), written(font, second, em)}, {{"1010", true}, {}}, PrintFont{font})[1].text;
    };
    EXPECT_EQ(text(U"L\u2081", 30), "L₁");
    EXPECT_EQ(text(U"\u2081", 30), "") << "alone";
    EXPECT_NE(text(U"L\u2081", 12), "L₁") << "of few pixels";
}

TEST(FormText, SaysWhatIsRaisedAndLowered) {
    FormFont font(strokes(0.1, 0.5));
    const auto text = [&](const std::vector<std::pair<char32_t, FormLetter::Place>>& letters) {
        FormReading reading;
        reading.em = 30;
        double left = 20;
        for (const auto& [code, place] : letters) {
            FormLetter letter;
            letter.code = code;
            letter.place = place;
            const double em = place == FormLetter::Place::on_line ? reading.em : 0.7 * reading.em;
            const LetterForm& form = font.form(code);
            letter.box = {left, 10, left + form.width() * em, 10 + form.height() * em};
            left += form.advance() * em;
            reading.letters.push_back(letter);
        }
        return text_of(reading, font);
    };
    using enum FormLetter::Place;
    EXPECT_EQ(text({{U'H', on_line}, {U'n', raised}}), "H^n");
    EXPECT_EQ(text({{U'H', on_line}, {U'1', raised}, {U'0', raised}}), "H\u00b9\u2070");
    EXPECT_EQ(text({{U'H', on_line}, {U'i', lowered}, {U'n', lowered}, {U'L', on_line}}), "H_inL");
    EXPECT_TRUE(same_letters("H_in", "Hin"));
    EXPECT_FALSE(same_letters("Hin", "H_in")) << "an underscore that was not seen";
}

// In another size than the words have.
TEST(PictureFonts, LinesThatBearEachOtherOutTellTheirSize) {
    const FontShapes font = strokes(0.1, 0.5);
    std::vector<Image> images{written(font, U"1010", 30), written(font, U"HL", 22)};
    std::vector<OtherReading> others{{"1010", true}, {}};
    EXPECT_FALSE(read_lines(images, others, PrintFont{font})[1].sized);
    images.push_back(written(font, U"Tn7", 22));
    others.push_back({});
    const std::vector<FormWords> words = read_lines(images, others, PrintFont{font});
    EXPECT_TRUE(words[1].sized);
    EXPECT_EQ(words[1].text, "HL");
    EXPECT_EQ(words[2].text, "Tn7");
}

TEST(PictureFonts, ShortPrintTellsAFontWhereNoWordDoes) {
    const FontShapes font = strokes(0.1, 0.5);
    const std::vector<Image> images{written(font, U"17", 30), written(font, U"HT", 30), written(font, U"L", 30)};
    const std::vector<FormWords> words = read_lines(images, {{}, {}, {}}, PrintFont{font});
    ASSERT_EQ(words.size(), 3u);
    EXPECT_EQ(words[0].text, "17");
    EXPECT_TRUE(words[0].sized && words[2].sized);
    const std::vector<FormWords> few = read_lines({images[2]}, {{}}, PrintFont{font});
    EXPECT_EQ(few[0].text, "");
}

// A diagram of arrows has small letters beside them, and may have two letters in all.
TEST(PictureFonts, TwoLettersThatFitTellASizeWhereTheyAreLarge) {
    const FontShapes font = strokes(0.1, 0.5);
    const auto is_sized = [&](const std::vector<std::pair<char32_t, double>>& letters, bool of_words) {
        std::vector<Image> images;
        std::vector<OtherReading> others;
        for (const auto& [letter, em] : letters) {
            images.push_back(written(font, std::u32string(1, letter), em));
            others.emplace_back();
        }
        if (of_words) {
            images.push_back(written(font, U"1010", 40));
            others.push_back({"1010", true});
        }
        return read_lines(images, others, PrintFont{font})[0].sized;
    };
    EXPECT_TRUE(is_sized({{U'T', 28}, {U'7', 28}}, false));
    EXPECT_TRUE(is_sized({{U'T', 28}, {U'7', 28}}, true)) << "of the font of the words";
    EXPECT_FALSE(is_sized({{U'T', 28}, {U'T', 28}}, false)) << "one letter twice";
    EXPECT_FALSE(is_sized({{U'T', 28}, {U'7', 26.5}}, false)) << "of two sizes";
    EXPECT_FALSE(is_sized({{U'T', 16}, {U'7', 16}}, false)) << "of few pixels";
}

// As the shares of a pie are: what is within its rings is no paler ink.
TEST(PictureFonts, PrintOnAColourIsAsSureAsOnWhite) {
    const FontShapes font = strokes(0.1, 0.5);
    for (const int ground : {255, 100}) {
        Image image = written(font, U"1H10", 30);
        for (std::uint8_t& pixel : image.pixels) pixel = static_cast<std::uint8_t>(pixel * ground / 255);
        LetteringLine line = line_in(image);
        line.level = ground == 255 ? 128 : 64;  // the nearest level to the middle may be either of two
        ReadLine read{line, print_of(image, line)};
        read.words.text = "1H10";
        read.words.sureness = 96;
        read.words.sure = read.alike = read.counted = true;
        std::vector<ReadLine> lines{read};
        ASSERT_TRUE(hold_against_fonts(image, lines, {}, [&](const auto&, const auto& goes_on) { goes_on(PrintFont{font}); }));
        EXPECT_TRUE(lines.at(0).words.sure) << ground;
    }
}

// Programs stretch letters upwards to whole pixels, and leave their widths.
TEST(PictureFonts, LettersAreBentToTheSizeThatTheirWidthsTell) {
    const FontShapes font = strokes(0.1, 0.5);
    FontShapes stretched = font;
    for (auto& [code, shape] : stretched)
        for (auto& ring : shape.rings)
            for (Point& corner : ring) corner.y *= 1.07;
    std::vector<double> sizes;
    PrintFont print{font};
    print.bent = [&](const std::vector<char32_t>&, double em) {
        sizes.push_back(em);
        return stretched;
    };
    const std::vector<FormWords> words = read_lines({written(stretched, U"1H10", 18)}, {{"1H10", true}}, print);
    ASSERT_EQ(sizes.size(), 1u);
    EXPECT_NEAR(sizes[0], 18, 0.3);
    EXPECT_GT(words[0].reading.mean, 0.93);
}

// Corners of a triangle are named as formulas have it.
TEST(PictureFonts, ShortPrintMayBeOfFormulas) {
    const FontShapes plain = strokes(0.1, 0.5);
    FontShapes formula = plain;
    formula[U'L'] = {0.6, {box(0.4, 0, 0.5, 0.7), box(0.05, 0, 0.5, 0.1)}};
    formula[U'T'] = {0.6, {box(0.05, 0, 0.55, 0.1), box(0.25, 0, 0.35, 0.7)}};
    formula[U'H'] = {0.7, {box(0.05, 0, 0.15, 0.7), box(0.5, 0, 0.6, 0.7), box(0.05, 0.6, 0.6, 0.7)}};
    const std::vector<Image> images{written(formula, U"L", 30), written(formula, U"T", 30), written(formula, U"H", 30)};
    const auto texts = [&](const PrintFont& font) {
        std::string all;
        for (const FormWords& words : read_lines(images, {{}, {}, {}}, font)) all += words.sized ? words.text : "?";
        return all;
    };
    EXPECT_EQ(texts(PrintFont{plain}), "???");
    EXPECT_EQ(texts(PrintFont{plain, {}, {}, [&](const auto&) { return formula; }}), "LTH");
}

// Dashes of a curve may be as high as figures, and are many more.
TEST(PictureFonts, DashesTellNoFont) {
    const FontShapes font = strokes(0.1, 0.5);
    std::vector<Image> images;
    for (int i = 0; i < 14; ++i) {
        Image& dash = images.emplace_back(make_image(320, 60, 1, 0, 255));
        for (int y = 20; y < 40; ++y)
            for (int x = 0; x < 4; ++x) dash.row(y)[30 + x + (y - 20) * (i + 2) / 16] = 0;
    }
    for (const char32_t letter : {U'7', U'H', U'T', U'L'}) images.push_back(written(font, std::u32string(1, letter), 30));
    const std::vector<FormWords> words = read_lines(images, std::vector<OtherReading>(images.size()), PrintFont{font});
    ASSERT_EQ(words.size(), 18u);
    EXPECT_EQ(words[14].text + words[15].text + words[16].text + words[17].text, "7HTL");
}

}  // namespace
}  // namespace tactics::picture_fonts_test
