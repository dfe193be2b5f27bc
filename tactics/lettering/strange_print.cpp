// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/strange_print.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tactics/lettering/alignment.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings. How like its ink a letter must be at least, and all of them in the mean; by so much another one must be more like it.
constexpr double kLeastLike = 0.48, kMeanLike = 0.56, kMoreLike = 0.08, kThinMoreLike = 0.01;
constexpr std::size_t kRivalFonts = 12, kBaseFonts = 12;
// Of the size in another font: capitals and small letters differ from font to font. Of an em: how far off the line.
constexpr double kLower = 0.78, kHigher = 1.28, kOffFoot = 0.14;
constexpr double kRivalSize = 0.15;  // of an em: so near must its size be
constexpr double kDashWidth = 0.4;   // em; what is narrower is a hyphen, in most fonts of 0.2 to 0.3, and an en dash has 0.5

std::u32string told_letters(std::string_view text) {
    std::u32string letters;
    while (!text.empty())
        if (const char32_t code = take_letter(text); code != ' ') letters += code;
    return letters;
}

// Whose shape tells which letter it is.
bool has_own_shape(char32_t code) { return is_digit(code) || (code | 32) - U'a' < 26 || (code >= 0x370 && code < 0x400); }

// Which one is meant is seen from the letters beside them.
bool are_drawn_alike(char32_t one, char32_t other) {
    for (const std::u32string_view group : {U"O0o", U"Il1|"})
        if (group.find(one) != group.npos && group.find(other) != group.npos) return true;
    return false;
}

// A dot or a bar makes it another.
bool is_thin_letter(char32_t code) { return std::u32string_view(U"Iil1tfj").find(code) != std::u32string_view::npos; }

// Of a text with those letters: the widest gap within words, and the narrowest between them, beyond what letters have around them
// in a font.
struct Gaps {
    double widest = 0, narrowest = std::numeric_limits<double>::max();
    bool told = false;  // the text has those letters
};

Gaps gaps_of(const FormReading& reading, std::string_view text, FormFont* font) {
    Gaps gaps;
    bool space = false;
    std::size_t at = 0;
    while (!text.empty() && at < reading.letters.size()) {
        const bool is_space = take_letter(text) == ' ';
        if (!is_space && at > 0) {
            const FormLetter &before = reading.letters[at - 1], &own = reading.letters[at];
            double gap = own.box.left - before.box.right;
            if (font != nullptr) {
                const LetterForm &form = font->form(before.code), &next = font->form(own.code);
                gap -= reading.em * (form.advance() - form.right() + next.left());
            }
            (space ? gaps.narrowest : gaps.widest) = space ? std::min(gaps.narrowest, gap) : std::max(gaps.widest, gap);
        }
        at += is_space ? 0 : 1;
        space = is_space;
    }
    gaps.told = text.empty() && at == reading.letters.size();
    return gaps;
}

class StrangeLine {
public:
    StrangeLine(const InkStrip& strip, const std::vector<FormFont*>& fonts) : strip_(strip), fonts_(fonts) {}

    std::optional<FormReading> read(const std::string& told) {
        const AlignedLine aligned = best_alignment(told_letters(told));
        double width = 0;
        reading_.em = aligned.em;
        reading_.foot = aligned.foot;
        reading_.least = 1;
        for (const AlignedLetter& one : aligned.letters) {
            FormLetter letter;
            letter.code = one.code;
            letter.box = one.box;
            letter.likeness = one.likeness;
            letter.touches = one.shared;
            if (!is_in_place(letter) || !(one.shared || look_at(letter, one))) return std::nullopt;
            reading_.least = std::min(reading_.least, letter.likeness);
            reading_.mean += letter.likeness * letter.box.width();
            width += letter.box.width();
            reading_.letters.push_back(std::move(letter));
        }
        if (!(width > 0)) return std::nullopt;
        reading_.mean /= width;
        if (reading_.mean < kMeanLike) return std::nullopt;
        if (has_clear_gaps(told)) reading_.text = told;
        return std::move(reading_);
    }

private:
    static constexpr double kPixels = 1.5;

    // In the font that has most of these letters in about these sizes.
    AlignedLine best_alignment(const std::u32string& letters) {
        AlignedLine best;
        for (std::size_t f = 0; f < std::min(kBaseFonts, fonts_.size()); ++f) {
            auto aligned = align(strip_, *fonts_[f], letters);
            if (!aligned || aligned->likeness <= best.likeness) continue;
            best = std::move(*aligned);
            base_ = fonts_[f];
        }
        return best;
    }

    bool is_in_place(const FormLetter& letter) const {
        const LetterForm& form = base_->form(letter.code);
        if (form.empty() || !(letter.box.width() > 0) || !(letter.box.height() > 0)) return false;
        if (letter.touches) return true;
        const double wanted = form.height() * reading_.em, is = letter.box.height();
        if (form.height() < kLowForm) return std::abs(is - wanted) <= kPixels + kOffFoot * reading_.em;
        const double off = reading_.foot - letter.box.bottom - form.bottom() * reading_.em;
        if (std::abs(off) > kPixels + kOffFoot * reading_.em) return false;
        return (is >= kLower * wanted - kPixels / 2 && is <= kHigher * wanted + kPixels / 2) && !is_other_case(letter);
    }

    // The gaps between its words are wider than all within them, and none within them is as wide as a space.
    bool has_clear_gaps(const std::string& told) const {
        constexpr double kSpace = 0.07, kWider = 1.6;
        const Gaps gaps = gaps_of(reading_, told, base_);
        return gaps.told && gaps.widest <= kSpace * reading_.em + kPixels / 2 && gaps.narrowest >= kWider * gaps.widest;
    }

    // It is as high as the small letter that looks like this capital, or the other way round.
    bool is_other_case(const FormLetter& letter) const {
        constexpr std::u32string_view kSame = U"cosuvwxz";
        if (kSame.find(letter.code | 32) == kSame.npos) return false;
        const LetterForm &own = base_->form(letter.code), &other = base_->form(letter.code ^ 32);
        if (own.empty() || other.empty()) return false;
        const double is = letter.box.height() / reading_.em, between = std::sqrt(own.height() * other.height());
        return own.height() > other.height() ? is < between : is > between;
    }

    // False: it looks like no such letter, or more like another.
    bool look_at(FormLetter& letter, const AlignedLetter& aligned) {
        LetterInk ink(strip_, aligned.first, aligned.last, letter.box);
        for (FormFont* font : fonts_)
            if (!font->form(letter.code).empty())
                letter.likeness = std::max(letter.likeness, ink.likeness(font->drawn(letter.code), letter.likeness));
        if (is_dash(letter.code) && letter.code != kMinus)
            letter.code = letter.box.width() > kDashWidth * reading_.em ? kEnDash : '-';
        if (!has_own_shape(letter.code)) {
            letter.likeness = std::max(letter.likeness, kMeanLike);  // a point is told by its place
            return true;
        }
        if (letter.likeness < kLeastLike) return false;
        for (const char32_t rival : letters_of_figures())
            if (are_drawn_alike(rival, letter.code)) {
                if (rival != letter.code) letter.alike.push_back(rival);
            } else if (has_own_shape(rival) && is_rival(rival, letter, ink))
                return false;
        return true;
    }

    bool is_rival(char32_t rival, const FormLetter& letter, LetterInk& ink) const {
        if (rival == letter.code || ((rival ^ letter.code) == 32 && rival < 0x80)) return false;
        for (std::size_t f = 0; f < std::min(kRivalFonts, fonts_.size()); ++f) {
            const LetterForm& form = fonts_[f]->form(rival);
            if (form.empty() || std::abs(letter.box.height() / form.height() - reading_.em) > kRivalSize * reading_.em) continue;
            const double off = reading_.foot - letter.box.bottom - form.bottom() * reading_.em;
            if (std::abs(off) > kOffFoot * reading_.em) continue;
            const double least = letter.likeness + (is_thin_letter(letter.code) ? kThinMoreLike : kMoreLike);
            if (least < 1 && ink.likeness(fonts_[f]->drawn(rival), least) >= least) return true;
        }
        return false;
    }

    const InkStrip& strip_;
    const std::vector<FormFont*>& fonts_;
    FormFont* base_ = nullptr;
    FormReading reading_;
};

}  // namespace

std::optional<FormReading> bear_out(const InkStrip& strip, const std::string& told, const std::vector<FormFont*>& fonts) {
    return StrangeLine(strip, fonts).read(told);
}

bool is_of_mixed_case(const FormReading& reading) {
    constexpr double kUneven = 0.86;
    constexpr std::u32string_view kHigh = U"ABCDEFGHIKLMNOPRSTUVWXYZ", kLow = U"acemnorsuvwxz";
    for (const std::u32string_view group : {kHigh, kLow}) {
        double least = std::numeric_limits<double>::max(), most = 0;
        for (const FormLetter& letter : reading.letters) {
            if (letter.place != FormLetter::Place::on_line || letter.touches || group.find(letter.code) == group.npos) continue;
            least = std::min(least, letter.box.height());
            most = std::max(most, letter.box.height());
        }
        if (most > 0 && least < kUneven * most - 1) return true;
    }
    return false;
}

std::optional<std::string> with_its_gaps(const FormReading& reading, const std::string& one, const std::string& other) {
    constexpr double kWider = 1.6, kSpace = 0.15,
                     kClear = 2;  // times as wide as all others; em; pixels, as letters lie between them
    const auto tells = [&](const std::string& text, bool clearly) {
        const Gaps gaps = gaps_of(reading, text, nullptr);
        if (!gaps.told || gaps.narrowest <= gaps.widest) return false;
        return !clearly || gaps.narrowest >= std::max({kWider * gaps.widest, gaps.widest + kClear, kSpace * reading.em});
    };
    const auto has_spaces = [](const std::string& text) { return text.find(' ') != text.npos; };
    if (has_spaces(one) != has_spaces(other)) {
        const std::string& spaced = has_spaces(one) ? one : other;
        return tells(spaced, true) ? std::optional(spaced) : std::nullopt;
    }
    const bool is_one = tells(one, false), is_other = tells(other, false);
    if (is_one == is_other) return std::nullopt;
    return is_one ? one : other;
}

bool may_be_figures(std::string_view text, bool strange) {
    constexpr std::string_view kBoth = "IlOo|", kThinOrRound = "IlO|";
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        if (strange && word.size() == 2 && (word[0] | 32) >= 'a' && (word[0] | 32) <= 'z' &&
            kThinOrRound.find(word[1]) != word.npos)
            return true;  // a letter with its number: "ql" and "q1"
        if (word.find_first_not_of("0123456789IlOo|") != word.npos) continue;
        const std::size_t both = word.find_first_of(kBoth), digit = word.find_first_of("0123456789");
        if (both == word.npos) continue;
        // "O2" is a gas.
        if (digit == word.npos ? strange : word.find_last_of(kBoth) > digit) return true;
    }
    return false;
}

}  // namespace tactics
