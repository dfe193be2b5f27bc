// SPDX-License-Identifier: Apache-2.0
// Print on a slope is found where it is, turned upright for the readers, and taken out as a whole; what only lies on slopes is
// not.
#include "tactics/lettering/sloped_print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/lettering/lettering.h"
#include "tactics/lettering/lines.h"
#include "tactics/lettering/turned_print.h"

namespace tactics::sloped_print_test {
namespace {

constexpr double kRadian = 3.14159265358979323846 / 180;

// Figures as a clock shows them: bars of a seven-part digit, 8 wide and 14 high with a pen of 2.
struct Bar {
    double left, top, right, bottom;
};
std::vector<Bar> bars_of(char digit, double left) {
    constexpr std::string_view kParts[] = {"abcdef", "bc",     "abged", "abgcd",   "fgbc",
                                           "afgcd",  "afgedc", "abc",   "abcdefg", "abcdfg"};
    std::vector<Bar> bars;
    for (const char part : kParts[digit - '0']) switch (part) {
            case 'a': bars.push_back({left, 0, left + 8, 2}); break;
            case 'b': bars.push_back({left + 6, 0, left + 8, 8}); break;
            case 'c': bars.push_back({left + 6, 6, left + 8, 14}); break;
            case 'd': bars.push_back({left, 12, left + 8, 14}); break;
            case 'e': bars.push_back({left, 6, left + 2, 14}); break;
            case 'f': bars.push_back({left, 0, left + 2, 8}); break;
            default: bars.push_back({left, 6, left + 8, 8});
        }
    return bars;
}
constexpr double kAdvance = 11, kDigit = 14;

// The text with its upper right corner there (upper left if it falls), each pixel by sixteen samples.
struct Set {
    double x, y, degrees;
    std::string text;
    double scale = 1;
};
void write(Image& image, const Set& set) {
    const double c = std::cos(set.degrees * kRadian), s = std::sin(set.degrees * kRadian),
                 length = kAdvance * static_cast<double>(set.text.size()) - 3, start = set.degrees > 0 ? -length : 0;
    std::vector<Bar> bars;
    for (std::size_t i = 0; i < set.text.size(); ++i)
        for (const Bar& bar : bars_of(set.text[i], start + kAdvance * static_cast<double>(i))) bars.push_back(bar);
    const int reach = static_cast<int>(std::max(1.0, set.scale) * (length + kDigit)), left = static_cast<int>(set.x),
              top = static_cast<int>(set.y);
    for (int y = std::max(0, top - reach); y < std::min(image.height, top + reach); ++y)
        for (int x = std::max(0, left - reach); x < std::min(image.width, left + reach); ++x) {
            int ink = 0;
            for (int sample = 0; sample < 16; ++sample) {
                const double dx = x + (sample % 4 + 0.5) / 4 - set.x, dy = y + (sample / 4 + 0.5) / 4 - set.y;
                const double u = (dx * c - dy * s) / set.scale, v = (dx * s + dy * c) / set.scale;
                ink += std::any_of(bars.begin(), bars.end(), [&](const Bar& bar) {
                    return u >= bar.left && u < bar.right && v >= bar.top && v < bar.bottom;
                });
            }
            if (ink > 0) image.row(y)[x] = static_cast<std::uint8_t>(255 - 255 * ink / 16);
        }
}

const std::vector<std::string> kNumbers{"201905", "218434", "206025", "257496"};

Image numbers_at(double degrees, double step = 80) {
    Image image = make_image(460, 220, 1, 0, 255);
    for (std::size_t i = 0; i < kNumbers.size(); ++i)
        write(image, {(degrees > 0 ? 110 : 30) + step * static_cast<double>(i), 60, degrees, kNumbers[i]});
    return image;
}

double ink_in(const Image& image) {
    double ink = 0;
    for (const std::uint8_t pixel : image.pixels) ink += 255 - pixel;
    return ink;
}

// Readers who read everything there, or nothing.
Lettering answer(const TurnedPrint& turned, bool sure) {
    Lettering lettering;
    for (const LetteringLine& line : find_lettering(turned.picture())) {
        PrintedWords words;
        words.text = "201905", words.sureness = 90, words.sure = sure;
        words.box = line.box;
        words.letter_height = line.letter_height;
        lettering.words.push_back(words);
    }
    return lettering;
}

TEST(SlopedPrint, IsFoundWithItsSlope) {
    for (const double degrees : {20.0, 30.0, 37.0, 45.0, 60.0, -30.0, -45.0, -65.0}) {
        const auto found = find_sloped_print(numbers_at(degrees));
        ASSERT_EQ(found.size(), kNumbers.size()) << degrees;
        for (const SlopedWords& words : found) {
            EXPECT_NEAR(words.slope / kRadian, degrees, 0.75);
            EXPECT_EQ(words.pieces.size(), 6u) << degrees;
            EXPECT_NEAR(words.height, kDigit, 1.5) << degrees;
        }
    }
}

// Their figures are as large as each other and have as much ink, as those of many fonts do.
TEST(SlopedPrint, MayHaveFiguresThatAreAlikeInSize) {
    for (const double degrees : {30.0, -45.0}) {
        Image image = make_image(460, 220, 1, 0, 255);
        const std::vector<std::string> numbers{"699669", "966969", "669999", "996966"};
        for (std::size_t i = 0; i < numbers.size(); ++i)
            write(image, {(degrees > 0 ? 110 : 30) + 80.0 * static_cast<double>(i), 60, degrees, numbers[i]});
        EXPECT_EQ(find_sloped_print(image).size(), numbers.size()) << degrees;
    }
}

TEST(SlopedPrint, LevelAndUprightPrintIsNone) {
    for (const double degrees : {0.0, 90.0, 3.0, -5.0}) {
        Image image = make_image(460, 420, 1, 0, 255);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                write(image, {120.0 + 110 * column, 130.0 + 120 * row, degrees, kNumbers[static_cast<std::size_t>(row)]});
        EXPECT_TRUE(find_sloped_print(image).empty()) << degrees;
    }
}

TEST(SlopedPrint, DashesAndMarksOnSlopesAreNone) {
    Image image = make_image(460, 220, 1, 0, 255);
    for (int line = 0; line < 4; ++line)
        for (int i = 0; i < 6; ++i) {
            const int x = 30 + 90 * line + 12 * i, y = 150 - 12 * i;
            for (int v = 0; v < 8; ++v)
                for (int u = 0; u < 8; ++u) {
                    const bool mark = line % 2 == 0 ? std::abs(u - v) < 2 || std::abs(u + v - 7) < 2  // a cross
                                                    : std::abs(u + v - 7) < 3;                        // a dash
                    if (mark) image.row(y + v)[x + u] = 0;
                }
        }
    EXPECT_TRUE(find_sloped_print(image).empty());
}

// Names of streets, each at its own slope; shorter ones may be anything.
TEST(SlopedPrint, NamesStandBesideTheirLines) {
    Image image = make_image(460, 260, 1, 0, 255);
    write(image, {200, 60, 30, "218434"});
    write(image, {250, 60, -40, "206025"});
    Image with_short = image;
    write(with_short, {440, 60, 50, "2594"});
    EXPECT_EQ(find_sloped_print(with_short).size(), 2u);
    const auto found = find_sloped_print(image);
    ASSERT_EQ(found.size(), 2u);
    for (const SlopedWords& words : found) {
        EXPECT_TRUE(words.name);
        EXPECT_NEAR(words.slope / kRadian, words.box.left < 240 ? 30 : -40, 0.75);
        EXPECT_EQ(words.pieces.size(), 6u);
    }
    const TurnedPrint turned{Image(image)};
    Lettering lettering = answer(turned, true);
    ASSERT_TRUE(turned.put_back(lettering));
    ASSERT_EQ(lettering.words.size(), 2u);
    for (const PrintedWords& words : lettering.words) {
        EXPECT_TRUE(words.sure);
        EXPECT_FALSE(words.at.has_value()) << "its middle";
    }
    Lettering silent;
    EXPECT_FALSE(turned.put_back(silent)) << "what nobody reads is no name";
    Lettering one = answer(turned, true);
    one.words.pop_back();
    ASSERT_TRUE(turned.put_back(one));
    ASSERT_EQ(one.words.size(), 2u);
    const PrintedWords& unread = one.words[one.words[0].text.empty() ? 0 : 1];
    EXPECT_TRUE(unread.text.empty());
    EXPECT_FALSE(unread.sure || unread.out) << "told, and left in the lines";
}

// Each of them leads to the name.
TEST(SlopedPrint, ANameOfTwoWordsIsOne) {
    constexpr double kGap = 10;
    for (const double slope : {14.0, 16.0, 18.0, 70.0, 74.0}) {
        Image image = make_image(460, 260, 1, 0, 255);
        const double c = std::cos(slope * kRadian), s = std::sin(slope * kRadian), before = 6 * kAdvance - 3 + kGap;
        write(image, {300, 30, slope, "218430"});
        write(image, {300 - before * c, 30 + before * s, slope, "257496"});
        const auto found = find_sloped_print(image);
        ASSERT_EQ(found.size(), 1u) << slope;
        EXPECT_EQ(found[0].pieces.size(), 12u) << slope;
    }
}

// A g may come apart, and its bowl hangs below the line; what lies farther off is of a cloud.
TEST(SlopedPrint, NamesMayHaveAPartLikeAThinLetter) {
    constexpr double kSlope = 30, kScale = 2, kGap = 18;
    const double c = std::cos(kSlope * kRadian), s = std::sin(kSlope * kRadian);
    for (const double down : {0.0, 5.0}) {
        Image image = make_image(700, 420, 1, 0, 255);
        const double length = kScale * (5 * kAdvance - 3), x = 640, y = 60, before = length + kGap;
        write(image, {x, y, kSlope, "21843", kScale});
        write(image, {x - before * c, y + before * s, kSlope, "42594", kScale});
        for (int v = 0; v < image.height; ++v)
            for (int u = 0; u < image.width; ++u) {
                const double along = (u + 0.5 - x) * c - (v + 0.5 - y) * s + length,
                             across = (u + 0.5 - x) * s + (v + 0.5 - y) * c;
                if (along > 3 - kGap && along < -3 && across > 20.2 + down && across < 37 + down) image.row(v)[u] = 0;
            }
        EXPECT_EQ(find_sloped_print(image).size(), down == 0 ? 1u : 0u) << down;
    }
}

// Below the picture its print is level: the finder of lines has each as one, and nothing of it is left above.
TEST(SlopedPrint, StandsUprightBelowThePicture) {
    for (const double degrees : {30.0, -50.0}) {
        const Image given = numbers_at(degrees);
        const TurnedPrint turned{Image(given)};
        ASSERT_TRUE(turned.any());
        const Image& picture = turned.picture();
        Image above = make_image(given.width, given.height, 1, 0, 255);
        for (int y = 0; y < given.height; ++y) std::copy_n(picture.row(y), given.width, above.row(y));
        EXPECT_EQ(ink_in(above), 0) << degrees;
        EXPECT_NEAR(ink_in(picture), ink_in(given), 0.02 * ink_in(given));  // turned about, ink is as much
        std::size_t lines = 0;
        for (const LetteringLine& line : find_lettering(picture)) {
            EXPECT_GE(line.box.top, given.height);
            lines += line.letters.size() == 6 ? 1 : 0;
        }
        EXPECT_EQ(lines, kNumbers.size()) << degrees;
    }
}

TEST(SlopedPrint, ComesBackToWhereItIs) {
    const Image given = numbers_at(30);
    const TurnedPrint turned{Image(given)};
    Lettering lettering = answer(turned, true);
    ASSERT_TRUE(turned.put_back(lettering));
    ASSERT_EQ(lettering.words.size(), kNumbers.size());
    lettering.width = given.width, lettering.height = given.height;
    std::sort(lettering.words.begin(), lettering.words.end(),
              [](const PrintedWords& a, const PrintedWords& b) { return a.box.left < b.box.left; });
    for (std::size_t i = 0; i < kNumbers.size(); ++i) {
        const PrintedWords& words = lettering.words[i];
        EXPECT_TRUE(words.sure);
        EXPECT_NEAR(words.box.right, 110 + 80 * static_cast<double>(i) + 7, 5);  // a corner of the last figure
        EXPECT_NEAR(words.box.top, 60, 2);
        EXPECT_NEAR(words.letter_height, kDigit, 1.5);
        ASSERT_TRUE(words.at.has_value());
        EXPECT_NEAR(words.at->x, words.box.right, 10);  // where it ends, not its middle
    }
    Image picture = given;
    take_out(picture, lettering, true);
    EXPECT_LT(ink_in(picture), 0.01 * ink_in(given));
}

TEST(SlopedPrint, IsToldAsAWholeIfAPartOfItIsLost) {
    const TurnedPrint turned(numbers_at(30));
    Lettering lettering = answer(turned, true);
    PixelBox& box = lettering.words.front().box;
    box.right = box.left + box.width() / 2;
    ASSERT_TRUE(turned.put_back(lettering));
    ASSERT_EQ(lettering.words.size(), kNumbers.size());
    EXPECT_EQ(std::count_if(lettering.words.begin(), lettering.words.end(), [](const PrintedWords& one) { return one.sure; }), 3);
    EXPECT_EQ(std::count_if(lettering.words.begin(), lettering.words.end(), [](const PrintedWords& one) { return one.out; }), 1);
}

// As an accent over a letter is, which its readers did not see.
TEST(SlopedPrint, OfFewPixelsWithMoreAboveItThanWasReadIsTold) {
    constexpr double kScale = 0.6, kSlope = 30;
    for (const int grey : {255, 160, 60}) {
        Image image = make_image(460, 220, 1, 0, 255);
        for (std::size_t i = 0; i < kNumbers.size(); ++i)
            write(image, {110 + 80.0 * static_cast<double>(i), 60, kSlope, kNumbers[i], kScale});
        const double c = std::cos(kSlope * kRadian), s = std::sin(kSlope * kRadian), u = kScale * (-2.5 * kAdvance), v = -2.5;
        const int x = static_cast<int>(190 + u * c + v * s), y = static_cast<int>(60 - u * s + v * c);
        image.row(y)[x] = image.row(y)[x + 1] = static_cast<std::uint8_t>(grey);
        const TurnedPrint turned{Image(image)};
        Lettering lettering = answer(turned, true);
        ASSERT_TRUE(turned.put_back(lettering));
        ASSERT_EQ(lettering.words.size(), kNumbers.size());
        const auto sure = std::count_if(lettering.words.begin(), lettering.words.end(), [](const auto& one) { return one.sure; });
        EXPECT_EQ(sure, grey == 255 ? 4 : 3) << grey;
    }
}

TEST(SlopedPrint, ThatNobodyReadsStaysInThePicture) {
    const TurnedPrint turned(numbers_at(30));
    Lettering lettering = answer(turned, false);
    const std::size_t before = lettering.words.size();
    EXPECT_FALSE(turned.put_back(lettering));
    EXPECT_EQ(lettering.words.size(), before);
}

TEST(SlopedPrint, StandsAtItsTick) {
    // Their middles are at the ticks, as some tools have it.
    Image image = numbers_at(45);
    const auto found = find_sloped_print(image);
    ASSERT_EQ(found.size(), kNumbers.size());
    std::vector<int> middles;
    for (const SlopedWords& words : found) middles.push_back((words.box.left + words.box.right) / 2);
    for (const int x : middles)
        for (int y = 50; y < 56; ++y) image.row(y)[x] = 0;
    std::fill(image.row(49) + 10, image.row(49) + 450, std::uint8_t{0});  // the axis
    const TurnedPrint turned{Image(image)};
    Lettering lettering = answer(turned, true);
    ASSERT_TRUE(turned.put_back(lettering));
    for (const PrintedWords& words : lettering.words) {
        ASSERT_TRUE(words.at.has_value());
        EXPECT_NEAR(words.at->x, (words.box.left + words.box.right) / 2.0, 2);
    }
}

}  // namespace
}  // namespace tactics::sloped_print_test
