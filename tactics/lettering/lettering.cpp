// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/lettering.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "tactics/lettering/agreement.h"
#include "tactics/lettering/read_line.h"
#include "tactics/lettering/strip.h"
#include "tactics/lettering/tesseract.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Heights of letters that Tesseract reads well; what is print is read alike at both.
constexpr std::array<int, 2> kHeights{32, 48};

constexpr std::size_t kMostLines = 300;  // of a picture; more is a page of text, and braille for it needs a book

// Pixels, of the tallest letter of a line. In smaller print a point is less than a pixel: at 72 dpi (8 pixels) "0.25" is read as
// "025" with 96 of 100, twice alike. A setting.
constexpr int kLeastHeight = 7;

constexpr double kSureAlone = 80;  // for a single letter in line with words. A setting

std::vector<char32_t> letters_of(std::string_view text) {
    std::vector<char32_t> letters;
    while (!text.empty()) letters.push_back(take_letter(text));
    return letters;
}

// A stroke before a digit is a minus sign, whichever dash was read.
std::string with_minus(std::string_view text) {
    const std::vector<char32_t> letters = letters_of(text);
    std::string out;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const bool begins = i == 0 || letters[i - 1] == ' ';
        const bool counts =
            i + 1 < letters.size() && (is_digit(letters[i + 1]) || letters[i + 1] == '.' || letters[i + 1] == ',');
        append_letter(out, begins && counts && is_dash(letters[i]) ? 0x2212 : letters[i]);
    }
    return out;
}

// "2" as an exponent. Nothing if it is no whole number.
std::optional<std::string> as_raised(std::string_view text) {
    std::string out;
    for (const char32_t letter : letters_of(text)) {
        const bool minus = out.empty() && is_dash(letter);
        if (!minus && !is_digit(letter)) return std::nullopt;
        append_letter(out, raised(minus ? U'-' : letter));
    }
    return out.empty() ? std::nullopt : std::optional(out);
}

bool has_letter_or_digit(std::string_view text) {
    return std::any_of(text.begin(), text.end(),
                       [](char c) { return (c & 0x80) != 0 || std::isalnum(static_cast<unsigned char>(c)) != 0; });
}

Guess joined(const Guess& base, const Guess* raised) {
    Guess guess{with_minus(base.text), base.sureness};
    if (raised == nullptr) return guess;
    const auto power = as_raised(raised->text);
    guess.sureness = power ? std::min(guess.sureness, raised->sureness) : 0;
    guess.text += power ? *power : "^" + raised->text;
    return guess;
}

// Marks of a plot are also as large as letters: a single letter is accepted only in line with words.
bool stands_with(const LetteringLine& lone, const std::vector<ReadLine>& all) {
    const double height = lone.letter_height;
    return std::any_of(all.begin(), all.end(), [&](const ReadLine& other) {
        if (!other.words.sure || other.line.letters.size() < 2 || other.line.upwards != lone.upwards) return false;
        if (std::abs(other.line.letter_height - height) > std::max(1.0, 0.15 * height)) return false;
        const PixelBox &a = lone.box, &b = other.line.box;
        const double near = std::max(1.0, 0.15 * height);
        const bool row = std::abs(a.bottom - b.bottom) <= near;
        const bool column = std::abs(a.right - b.right) <= near || std::abs(a.left - b.left) <= near;
        return row || column;
    });
}

// Ink that is neither certain nor looks like print belongs to the drawing and is not reported; otherwise the bends of a curve
// would be letters.
bool may_be_words(const ReadLine& one, const std::vector<ReadLine>& all) {
    constexpr double kLikely = 30, kLikelyAlone = 80;  // settings; a mark of a plot is read as a letter with 50 to 75
    const bool alone = one.line.letters.size() < 2;
    if (!has_letter_or_digit(one.words.text) || one.words.sureness < (alone ? kLikelyAlone : kLikely)) return false;
    if (!alone) return true;
    return one.alike && one.counted && std::any_of(all.begin(), all.end(), [&](const ReadLine& other) {
               const double ratio = static_cast<double>(one.line.letter_height) / other.line.letter_height;
               return other.words.sure && ratio > 0.6 && ratio < 1.6;
           });
}

// Of the lines that have one piece of ink: whether it is as high as letters of words there, and as wide as two of them that
// touch, as those with serifs do.
std::vector<bool> may_be_joined(const std::vector<LetteringLine>& lines) {
    constexpr double kLowest = 0.75, kHighest = 1.15, kWidest = 3;  // settings, of the height
    constexpr std::size_t kMostAsked = 12;                          // more are marks
    std::vector<int> heights;
    for (const LetteringLine& line : lines)
        if (is_words(line)) heights.push_back(line.letter_height);
    std::vector<bool> may(lines.size(), false);
    if (heights.empty()) return may;
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), middle, heights.end());
    std::size_t asked = 0;
    for (std::size_t i = 0; i < lines.size() && asked < kMostAsked; ++i) {
        const LetteringLine& line = lines[i];
        const double height = line.letter_height, width = line.upwards ? line.box.height() : line.box.width();
        may[i] = !is_words(line) && height >= kLowest * *middle && height <= kHighest * *middle && width > height &&
                 width <= kWidest * height;
        asked += may[i] ? 1 : 0;
    }
    return may;
}

// Tesseract's reading of each line, at two sizes. Single letters are also read if no font can identify them, or if they may be
// two.
struct Asked {
    std::vector<ReadLine> all;
    Phrase trouble;
};

Asked ask_tesseract(const Image& grey, std::vector<LetteringLine> lines, bool ask_alone, std::string_view language,
                    double least_sure, const std::string& program) {
    const std::vector<bool> may_be_two = may_be_joined(lines);
    std::vector<bool> is_asked = may_be_two;
    for (std::size_t i = 0; i < lines.size(); ++i) is_asked[i] = is_asked[i] || ask_alone || is_words(lines[i]);
    std::vector<Image> strips;
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (const int height : kHeights) {
            const LetteringLine& line = lines[i];
            if (!is_asked[i]) continue;
            strips.push_back(strip_of(grey, line, Part::words, height));
            if (!line.raised.empty()) strips.push_back(strip_of(grey, line, Part::raised, height));
        }
    Guesses read = read_strips(strips, language, program);
    Asked asked{{}, std::move(read.trouble)};
    if (!asked.trouble.empty()) return asked;
    std::size_t at = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ReadLine one{std::move(lines[i]), {}};
        std::array<Guess, kHeights.size()> guesses;
        for (Guess& guess : guesses) {
            if (!is_asked[i]) continue;
            const Guess& base = read.guesses[at++];
            guess = joined(base, one.line.raised.empty() ? nullptr : &read.guesses[at++]);
            if (may_be_two[i] && letters_in(guess.text) < 2) guess = {};  // a dash is read as "/"
        }
        one.words = print_of(grey, one.line);
        for (const Guess& guess : guesses)
            if (!guess.text.empty()) one.readings.push_back(guess.text);
        one.words.text = guesses[0].text;
        one.words.sureness = std::min(guesses[0].sureness, guesses[1].sureness);
        const auto parts = static_cast<std::size_t>(std::count(one.words.text.begin(), one.words.text.end(), ' ')) + 1;
        const WordCount count = words_in(one.line);
        one.alike = !guesses[0].text.empty() && guesses[0].text == guesses[1].text;
        one.counted = parts >= count.least && parts <= count.most;
        // Two pieces that are no letters are read as two letters more easily than five as five: "of" with 72, "aa" with 84. A
        // setting.
        constexpr std::size_t kFew = 2;
        constexpr double kSureOfFew = 90;
        const double least =
            one.line.letters.size() + one.line.marks.size() <= kFew ? std::max(least_sure, kSureOfFew) : least_sure;
        one.words.sure = one.alike && one.counted && one.line.letter_height >= kLeastHeight && one.words.sureness >= least &&
                         is_words(one.line) && has_letter_or_digit(one.words.text);
        asked.all.push_back(std::move(one));
    }
    return asked;
}

void believe_lone_letters(std::vector<ReadLine>& all) {
    for (ReadLine& one : all) {
        const bool believed = one.alike && one.counted && one.line.letter_height >= kLeastHeight &&
                              one.words.sureness >= kSureAlone && has_letter_or_digit(one.words.text);
        if (!is_words(one.line) && believed && stands_with(one.line, all)) one.words.sure = true;
    }
}

void doubt_by_text(std::vector<ReadLine>& all) {
    for (ReadLine& one : all)
        if (one.words.sure && (has_letter_for_figure(one.words.text) || begins_in_formula(one.words.text) ||
                               ends_word_with_capital_i(one.words.text))) {
            one.words.sure = false;
            one.tell = true;
        }
}

}  // namespace

Lettering read_upright(const Image& grey, std::string_view language, double least_sure, const PrintFonts& fonts,
                       const std::string& program) {
    Lettering lettering;
    lettering.width = grey.width;
    lettering.height = grey.height;
    std::vector<LetteringLine> climbing, low;
    std::vector<LetteringLine> lines = find_lettering(grey, fonts ? &climbing : nullptr, &low);
    add_low_print(grey, lines, std::move(low));
    lettering.found_any = std::any_of(lines.begin(), lines.end(), is_words) || (fonts && !lines.empty());
    if (!lettering.found_any) return lettering;
    std::stable_partition(lines.begin(), lines.end(), is_words);
    if (lines.size() > kMostLines) lines.resize(kMostLines);
    const std::size_t own = lines.size();
    const std::vector<FreedLine> freed = fonts ? freed_lines(grey, lines) : std::vector<FreedLine>();
    for (const FreedLine& one : freed) lines.push_back(one.line);
    Asked asked = ask_tesseract(grey, std::move(lines), !fonts, language, least_sure, program);
    lettering.trouble = std::move(asked.trouble);
    if (!lettering.trouble.empty()) return lettering;
    std::vector<ReadLine>& all = asked.all;
    for (std::size_t i = 0; i < freed.size(); ++i) all[own + i].freed = freed[i].freed;
    if (!fonts || !hold_against_fonts(grey, all, std::move(climbing), fonts)) believe_lone_letters(all);
    doubt_by_text(all);
    hold_against_axes(all);
    doubt_parted(grey, all);
    for (ReadLine& one : all) one.likely = may_be_words(one, all);
    std::vector<bool> unread = unread_print(grey, all), certain = certain_print(all);
    const std::vector<SmallPrint> small = small_print(grey, all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool mark = small[i] == SmallPrint::mark;
        all[i].tell = all[i].tell && !mark;
        unread[i] = !mark && (unread[i] || small[i] != SmallPrint::none);
        certain[i] = certain[i] || small[i] == SmallPrint::out;
    }
    doubt_parts(grey, all, unread);
    if (fonts)
        for (const LetteringLine& loose : loose_letters(grey, all)) lettering.words.push_back(print_of(grey, loose));
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].words.sure && !all[i].tell && !unread[i]) continue;
        // Two marks of a plot are read as two letters, but seldom three as three.
        constexpr std::size_t kLetters = 3;
        all[i].words.print = all[i].words.sure || all[i].tell || (all[i].likely && all[i].line.letters.size() >= kLetters);
        all[i].words.out = certain[i];
        if (unread[i] && !has_letter_or_digit(all[i].words.text)) all[i].words.text.clear();
        lettering.words.push_back(std::move(all[i].words));
    }
    return lettering;
}

}  // namespace tactics
