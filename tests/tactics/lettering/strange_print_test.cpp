// SPDX-License-Identifier: Apache-2.0
// Print in a font that is not installed.
#include "tactics/lettering/strange_print.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tactics/lettering/alignment.h"
#include "tactics/lettering/form_words.h"
#include "tactics/lettering/meant_letters.h"
#include "tactics/lettering/pale_ink.h"
#include "tactics/lettering/read_line.h"
#include "tactics/text/utf8.h"

namespace tactics::strange_print_test {
namespace {

std::vector<Point> box(double left, double bottom, double right, double top) {
    return {{left, bottom}, {left, top}, {right, top}, {right, bottom}};
}

FontShape ring(double width, double height, double thick) {
    return {width + 0.1,
            {box(0.05, 0, 0.05 + width, thick), box(0.05, height - thick, 0.05 + width, height),
             box(0.05, 0, 0.05 + thick, height), box(0.05 + width - thick, 0, 0.05 + width, height)}};
}

// Letters of straight strokes so thick, small ones so high: L, T, H, O, o, n, i, 0 and 1, and a 7 of so many times their height.
FontShapes strokes(double thick, double low, double seven = 1) {
    return {{U'L', {0.6, {box(0.05, 0, 0.05 + thick, 0.7), box(0.05, 0, 0.5, thick)}}},
            {U'T', {0.6, {box(0.05, 0.7 - thick, 0.55, 0.7), box(0.3 - thick / 2, 0, 0.3 + thick / 2, 0.7)}}},
            {U'H', {0.7, {box(0.05, 0, 0.05 + thick, 0.7), box(0.6 - thick, 0, 0.6, 0.7), box(0.05, 0.33, 0.6, 0.33 + thick)}}},
            {U'O', ring(0.6, 0.7, thick)},
            {U'o', ring(0.4, low, thick)},
            {U'0', ring(0.4, 0.7, thick)},
            {U'n', {0.5, {box(0.05, 0, 0.05 + thick, low), box(0.45 - thick, 0, 0.45, low), box(0.05, low - thick, 0.45, low)}}},
            {U'i', {0.25, {box(0.1, 0, 0.1 + thick, low), box(0.1, 0.6, 0.1 + thick, 0.7)}}},
            {U'1', {0.5, {box(0.22, 0, 0.22 + thick, 0.7), box(0.08, 0, 0.4, thick), box(0.1, 0.55, 0.25, 0.6)}}},
            {U'7',
             {0.5 * seven,
              {box(0.05 * seven, 0.6 * seven, 0.42 * seven, 0.7 * seven), box(0.3 * seven, 0, 0.42 * seven, 0.7 * seven)}}}};
}

// As a program does that fades edges: each pixel by parts of it, whose middles are within a box.
Image written(const FontShapes& font, std::u32string_view text, double em, double closer = 0) {
    Image image = make_image(320, 60, 1, 0, 255);
    constexpr int kParts = 4;
    double left = 20.3;
    for (const char32_t code : text) {
        if (code == U' ') {
            left += 0.35 * em;
            continue;
        }
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                int inside = 0;
                for (int part = 0; part < kParts * kParts; ++part) {
                    const double px = (x + (part % kParts + 0.5) / kParts - left) / em,
                                 py = (40.6 - y - (part / kParts + 0.5) / kParts) / em;
                    const auto& rings = font.at(code).rings;
                    inside += std::any_of(rings.begin(), rings.end(), [&](const auto& one) {
                        return px > one[0].x && px < one[2].x && py > one[0].y && py < one[2].y;
                    });
                }
                std::uint8_t& pixel = image.row(y)[x];
                pixel = static_cast<std::uint8_t>(std::min<int>(pixel, 255 - 255 * inside / (kParts * kParts)));
            }
        left += (font.at(code).advance - closer) * em;
    }
    return image;
}

LetteringLine line_in(const Image& image) {
    const auto lines = find_lettering(image);
    EXPECT_EQ(lines.size(), 1u);
    return lines.empty() ? LetteringLine() : lines[0];
}

// Written in a thinner font, whose small letters are lower, than the one that is known.
std::optional<FormReading> borne_out(std::u32string_view text, const std::string& told, double low = 0.46) {
    const Image image = written(strokes(0.08, low), text, 30);
    FormFont known(strokes(0.12, low + 0.04));
    return bear_out(InkStrip(image, line_in(image)), told, {&known});
}

TEST(StrangePrint, IsBorneOutLetterByLetter) {
    const auto reading = borne_out(U"LoTnHi", "LoTnHi");
    ASSERT_TRUE(reading.has_value());
    EXPECT_EQ(reading->text, "LoTnHi");
    EXPECT_NEAR(reading->em, 30, 2);
    EXPECT_FALSE(borne_out(U"LoTnHi", "LoLnHi").has_value()) << "a T is no L";
    EXPECT_FALSE(borne_out(U"LnTnHi", "LoTnHi").has_value()) << "it looks more like an n";
    EXPECT_FALSE(borne_out(U"LoTnHi", "LOTnHi").has_value()) << "it is too low for a capital";
    EXPECT_FALSE(borne_out(U"LOTnHi", "LoTnHi").has_value()) << "it is too high for a small one";
    EXPECT_FALSE(borne_out(U"LoTnHi", "LOTnHi", 0.58).has_value()) << "though small letters are high";
    EXPECT_FALSE(borne_out(U"LoTnHi", "LoTnH").has_value()) << "a letter is left";
    EXPECT_FALSE(borne_out(U"LoTnHi", "LoTnHiL").has_value()) << "a letter has no ink";
    EXPECT_FALSE(borne_out(U"LoTnHi", "").has_value());
}

TEST(StrangePrint, HasItsSpacesWhereTheGapsAre) {
    EXPECT_EQ(borne_out(U"Lon Hin", "Lon Hin")->text, "Lon Hin");
    EXPECT_EQ(borne_out(U"Lon Hin", "LonHin")->text, "") << "a space is not told";
    EXPECT_EQ(borne_out(U"LonHin", "Lon Hin")->text, "") << "there is no gap";
    const auto reading = borne_out(U"Lon Hin", "Lon Hin");
    EXPECT_EQ(with_its_gaps(*reading, "LonHin", "Lon Hin"), "Lon Hin");
    EXPECT_EQ(with_its_gaps(*borne_out(U"LonHin", "LonHin"), "LonHin", "Lon Hin"), std::nullopt) << "gaps as wide as others";
    EXPECT_EQ(with_its_gaps(*reading, "LonH in", "Lon Hin"), "Lon Hin");
    EXPECT_EQ(with_its_gaps(*reading, "Lon Hin", "Lo nHin"), "Lon Hin");
}

TEST(Alignment, FindsLettersThatTouchAndLettersThatCameApart) {
    FormFont font(strokes(0.12, 0.5));
    const Image close = written(strokes(0.1, 0.5), U"LonHi", 30, 0.12);
    const InkStrip joined(close, line_in(close));
    ASSERT_LT(joined.units(), 5u);
    const auto touching = align(joined, font, U"LonHi");
    ASSERT_TRUE(touching.has_value());
    ASSERT_EQ(touching->letters.size(), 5u);
    EXPECT_TRUE(
        std::any_of(touching->letters.begin(), touching->letters.end(), [](const AlignedLetter& one) { return one.shared; }));
    for (std::size_t i = 1; i < 5; ++i) EXPECT_GT(touching->letters[i].box.left, touching->letters[i - 1].box.left) << i;

    FontShapes broken = strokes(0.1, 0.5);
    broken.at(U'n').rings.pop_back();  // two stems
    const Image apart = written(broken, U"LonHi", 30);
    const InkStrip pieces(apart, line_in(apart));
    ASSERT_EQ(pieces.units(), 6u);
    const auto found = align(pieces, font, U"LonHi");
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->letters[2].last, found->letters[2].first + 1);
    EXPECT_EQ(found->letters[3].first, found->letters[2].last + 1);
}

TEST(StrangePrint, CapitalsAndSmallLettersAreEachOfOneHeight) {
    const auto reading = [](std::initializer_list<std::pair<char32_t, double>> letters) {
        FormReading made;
        for (const auto& [code, height] : letters) {
            FormLetter letter;
            letter.code = code;
            letter.box = {0, 0, 10, height};
            made.letters.push_back(letter);
        }
        return made;
    };
    EXPECT_TRUE(is_of_mixed_case(reading({{U'R', 20}, {U'o', 15}, {U'W', 15}}))) << "Row";
    EXPECT_FALSE(is_of_mixed_case(reading({{U'R', 20}, {U'o', 15}, {U'w', 15}})));
    EXPECT_TRUE(is_of_mixed_case(reading({{U's', 20}, {U'a', 15}, {U'w', 15}}))) << "Saw";
    EXPECT_FALSE(is_of_mixed_case(reading({{U'B', 10}, {U'W', 9}}))) << "a pixel is no difference";
    FormReading touching = reading({{U'r', 20}, {U'l', 20}, {U'a', 15}});
    EXPECT_TRUE(is_of_mixed_case(touching));
    touching.letters[0].touches = true;
    EXPECT_FALSE(is_of_mixed_case(touching)) << "its height is that of both";
}

TEST(StrangePrint, RingsAndStrokesBesideFiguresMayBeFigures) {
    EXPECT_TRUE(may_be_figures("7O", false));
    EXPECT_TRUE(may_be_figures("up to 1l", false));
    EXPECT_FALSE(may_be_figures("O2", true));
    EXPECT_FALSE(may_be_figures("70", true));
    EXPECT_FALSE(may_be_figures("q0", true));
    EXPECT_TRUE(may_be_figures("IO", true));
    EXPECT_FALSE(may_be_figures("II", false));
    EXPECT_TRUE(may_be_figures("from ql", true)) << "q1";
    EXPECT_FALSE(may_be_figures("ql", false));
    EXPECT_FALSE(may_be_figures("so", true));
    EXPECT_FALSE(may_be_figures("", true));
}

TEST(StrangePrint, NoWordBeginsWithAnLAndAnotherConsonant) {
    const auto settled = [](std::u32string_view codes, const std::string& told) {
        FormWords words;
        for (const char32_t code : codes) {
            FormLetter letter;
            letter.code = code;
            if (code == U'l') letter.alike = {U'I'};
            words.reading.letters.push_back(letter);
            append_letter(words.reading.text, code);
        }
        words.reading.em = 20;
        settle(words, {told, true});
        return words.settled;
    };
    EXPECT_FALSE(settled(U"lron", "lron"));
    EXPECT_TRUE(settled(U"lane", "lane"));
    EXPECT_TRUE(settled(U"lyre", "lyre"));
    EXPECT_TRUE(settled(U"llama", "llama"));
    EXPECT_TRUE(settled(U"lb", "lb"));
}

TEST(StrangePrint, ALoneFigureIsAsHighAsOthers) {
    const FontShapes strange = strokes(0.1, 0.46), known = strokes(0.12, 0.5, 0.85);
    const Image numbers = written(strange, U"1010", 30), seven = written(strange, U"7", 30), small = written(strange, U"7", 22);
    const std::vector<InkStrip> strips{InkStrip(numbers, line_in(numbers)), InkStrip(seven, line_in(seven)),
                                       InkStrip(small, line_in(small))};
    const PrintFonts fonts = [&](const std::vector<char32_t>&, const std::function<bool(PrintFont)>& goes_on) {
        goes_on(PrintFont{known});
    };
    const std::vector<FormWords> words = read_in_fonts(strips, {{"1010", true}, {}, {}}, fonts);
    ASSERT_EQ(words.size(), 3u);
    EXPECT_EQ(words[1].text, "7");
    EXPECT_TRUE(words[1].sized) << "as high as the other figures, though not of their em in the known font";
    EXPECT_FALSE(words[2].sized);
}

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

TEST(StrangePrint, ALoneFigureOfNoFontOfTheWordsIsLeftToItsAxis) {
    const FontShapes strange = strokes(0.1, 0.46);
    FontShapes without = strokes(0.12, 0.5);
    without.erase(U'7');
    const Image numbers = written(strange, U"1010", 30), seven = written(strange, U"7", 30);
    const std::vector<InkStrip> strips{InkStrip(numbers, line_in(numbers)), InkStrip(seven, line_in(seven))};
    const PrintFonts fonts = [&](const std::vector<char32_t>&, const std::function<bool(PrintFont)>& goes_on) {
        goes_on(PrintFont{without});
        goes_on(PrintFont{{{U'7', strange.at(U'7')}}});
    };
    const std::vector<FormWords> words = read_in_fonts(strips, {{"1010", true}, {}}, fonts);
    ASSERT_EQ(words.size(), 2u);
    EXPECT_EQ(words[1].text, "");
    EXPECT_EQ(words[1].reading.text, "7");
}

Image broken_ring() {
    Image image = make_image(60, 40, 1, 0, 255);
    const auto fill = [&](int left, int top, int right, int bottom, std::uint8_t value) {
        for (int y = top; y < bottom; ++y) std::fill(image.row(y) + left, image.row(y) + right, value);
    };
    fill(20, 10, 22, 26, 0);  // a 0 whose arcs are thin
    fill(30, 10, 32, 26, 0);
    fill(22, 10, 30, 11, 170);
    fill(22, 25, 30, 26, 170);
    return image;
}

TEST(PaleInk, JoinsWhatThinStrokesLeaveApart) {
    Image image = broken_ring();
    LetteringLine line = line_in(image);
    ASSERT_EQ(line.letters.size(), 2u);
    EXPECT_EQ(joined_by_pale_ink(image, line).letters.size(), 1u);
    std::fill(image.row(10), image.row(10) + 20, std::uint8_t{170});  // a pale line leads out of it
    EXPECT_EQ(joined_by_pale_ink(image, line).letters.size(), 2u);
}

TEST(PaleInk, HalvesOfARingAreOneLetter) {
    const Image image = broken_ring();
    const auto letters_of = [&](const std::string& text, bool alike) {
        std::vector<ReadLine> lines(1);
        lines[0].line = line_in(image);
        lines[0].words.text = text;
        lines[0].alike = alike;
        EXPECT_TRUE(hold_against_fonts(image, lines, {},
                                       [](const auto&, const auto& goes_on) { goes_on(PrintFont{strokes(0.1, 0.5)}); }));
        return lines[0].line.letters.size();
    };
    EXPECT_EQ(letters_of("0)", false), 1u);
    EXPECT_EQ(letters_of("()", true), 2u) << "read twice alike";
}

}  // namespace
}  // namespace tactics::strange_print_test
