// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/agreement.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "tactics/lettering/meant_letters.h"
#include "tactics/lettering/strange_print.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings. Print that is bent to pixels, in fonts with serifs at 100 dpi, is like its letters with 0.79 to 0.92; letters that
// are none of the font seldom reach 0.7.
struct Likely {
    double mean, least;
    bool holds(const FormReading& reading) const { return reading.mean >= mean && reading.least >= least; }
};
constexpr Likely kBothSay{0.8, 0.7}, kBothSayOfFew{0.84, 0.78}, kOfKnownSize{0.85, 0.74}, kOfItself{0.93, 0.85}, kTold{0.75, 0.6};
// Print of few pixels is less like its letters, and still unlike all others: by these margins each letter must beat the next.
constexpr Likely kSmallBothSay{0.72, 0.62}, kSmallOfKnownSize{0.8, 0.7}, kAlone{0.94, 0.9};
// How sure the other reader must be of words in no known font, and of those that are less than kLikeAny like the letters of any.
constexpr double kSureStrange = 90, kSureUnlike = 95, kLikeAny = 0.66;
constexpr double kMargin = 0.03, kClearMargin = 0.07, kAgainstOther = 0.1;
constexpr std::size_t kLetters = 4;  // that many are no accident
constexpr double kSureWords = 88;    // of 100: leaves and stones are read as words with less
constexpr double kTinyPrint = 13;    // pixels for an em, in which nothing tells a word that ends with m from one with rn
constexpr double kSpeckPrint = 9.5;  // pixels for an em, in which the gaps of 3, 6 and 9 close, and 6 and 8 are alike
constexpr double kBearsOut = 0.72;   // of a letter
// What two letters that touch look like with a likeness of 0.8, and how like one of these must be.
constexpr std::u32string_view kLikeTwo = U"mdOJjnwh";
constexpr double kClear = 0.86;

bool is_of_words(char32_t code) { return ((code | 32) >= 'a' && (code | 32) <= 'z') || code >= 0xC0; }
bool is_word_letter(char32_t code) {
    return (code >= '0' && code <= '9') || ((code | 32) >= 'a' && (code | 32) <= 'z') || code >= 0x80;
}

// The pieces that are like letters are letters of that text, in its order, and what is left of it are letters, too: a figure or a
// point may be anything.
bool bears_out(const FormReading& reading, std::string_view text) {
    constexpr double kShare = 0.7, kFarBelow = 0.12;
    constexpr std::u32string_view kBelow = U"gjpqyQJ,;()[]{}|/_$@";
    // Which other readers take for each other, and in small print for two.
    const std::string_view confused = reading.em < kSmallPrint ? "gqlIOmdnhwUCJjF" : "gqlIO";
    std::vector<char32_t> letters;
    while (!text.empty())
        if (const char32_t letter = take_letter(text); letter != ' ') letters.push_back(letter);
    std::size_t at = 0, found = 0, passed = 0, unlike = 0;
    bool plain = true, reaches_below = false, below = false, letter_found = false;
    const auto pass = [&] {
        ++passed;
        below = below || kBelow.find(letters[at]) != kBelow.npos;
        const bool is_letter = (letters[at] | 32) >= 'a' && (letters[at] | 32) <= 'z';
        plain = plain && is_letter && confused.find(static_cast<char>(letters[at])) == confused.npos;
        ++at;
    };
    for (const FormLetter& letter : reading.letters) {
        if (letter.code == 0 || letter.likeness < kBearsOut) {
            ++unlike;
            reaches_below = reaches_below || letter.box.bottom > reading.foot + kFarBelow * reading.em;
            continue;
        }
        if (letter.place != FormLetter::Place::on_line) return false;  // which the text does not say
        while (at < letters.size() && !letter.may_be(letters[at])) pass();
        if (at == letters.size()) return false;
        letter_found = letter_found || is_of_words(letter.code);
        ++at;
        ++found;
    }
    while (at < letters.size()) pass();
    if (unlike > 0 && !letter_found) return false;  // "a = 30°" was read, and is "α = 30°"
    if (unlike > 0 && passed == 0) return false;    // a point, which the text has not
    if (reaches_below && !below) return false;      // "et" was read, and is "gt"
    return plain && !letters.empty() && static_cast<double>(found) >= kShare * static_cast<double>(letters.size());
}

// Whether a figure has its thousands set apart: 1.000 or 1,000.
bool has_thousands(std::string_view text) {
    std::size_t before = 0, behind = 0;
    bool sign = false;
    const auto is_one = [&] { return sign && behind == 3; };
    for (const char c : text) {
        if (c >= '0' && c <= '9') {
            ++(sign ? behind : before);
            continue;
        }
        if (is_one()) return true;
        sign = (c == '.' || c == ',') && before > 0;
        before = behind = 0;
    }
    return is_one();
}

// How many strokes side by side there are is not to be seen where each is a pixel wide: "ill" and "il".
bool is_all_thin(const FormReading& reading) {
    constexpr std::u32string_view kThin = U"ilI|!";
    return std::all_of(reading.letters.begin(), reading.letters.end(),
                       [&](const FormLetter& letter) { return kThin.find(letter.code) != kThin.npos; });
}

// A 0 that other figures follow has lost its point.
bool has_lost_point(std::string_view text) {
    return text.size() > 1 && text[0] == '0' &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// What ends with a dash behind figures goes on, as in "1e-14", or that is the tick of a scale.
bool breaks_off(std::string_view text) {
    return (text.ends_with('-') || text.ends_with("\u2212") || text.ends_with("\u2013")) &&
           std::any_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// In small print a comma without its tail is a point, O and 0 look alike, a raised figure is a star, and a long figure that two
// readers do not both say is none.
bool is_plain(const std::string& text, const std::string& other, bool agreed) {
    const auto count = [&](const auto& is) { return std::count_if(text.begin(), text.end(), is); };
    const auto digits = count([](char c) { return c >= '0' && c <= '9'; });
    const auto letters = count([](char c) { return (c | 32) >= 'a' && (c | 32) <= 'z'; });
    const bool either = text.find('0') != text.npos && text.find('O') != text.npos;
    const bool star = digits > 0 && text.find('*') != text.npos;  // a small raised figure
    if (either || star || count([](char c) { return c == '"'; }) % 2 == 1 || has_lost_point(text)) return false;
    if (has_thousands(text) && !text.starts_with("0.") && (text != other || text.find(',') == text.npos)) return false;
    return letters > 0 || digits < 3 || agreed;
}

// Letters of small print that touch look like one, unless they are far more like themselves: rn and m, cl and d, Cl and O.
bool is_no_pair(const FormWords& words, const ReadWords& other) {
    constexpr double kCertain = 0.9;  // of such a letter
    const bool tiny = words.reading.em < kTinyPrint;
    // A unit above an axis, which the other reader is often not shown.
    if (words.sized && is_degrees(words.text)) return true;
    // S and 8, or B and 8, are told apart by one reader no longer.
    if (tiny && (!words.agreed || is_all_thin(words.reading))) return false;
    bool any = false, two = false, clear = true, certain = !tiny || words.sized;
    for (const FormLetter& letter : words.reading.letters) {
        any = any || (letter.code | 32) - U'a' < 26;
        if (kLikeTwo.find(letter.code) == kLikeTwo.npos) continue;
        two = true;
        clear = clear && letter.likeness >= kClear && !letter.pair;
        certain = certain && letter.likeness >= kCertain;
    }
    if (any && tiny && words.text.size() > 2 && words.text.back() == 'm') return false;
    if (!words.agreed) return !any || (!tiny && words.sized && kAlone.holds(words.reading) && certain && clear);
    return !any || !two || (clear && (certain || other.sureness >= kSureWords));
}

// The other reader has two letters in place of this one, and all others alike: "Furnace" and "Fumace".
bool is_said_as_two(const FormLetter& one, const FormWords& words, const ReadWords& other) {
    constexpr std::pair<char32_t, std::string_view> kPairs[] = {
        {U'm', "rn"}, {U'd', "cl"}, {U'w', "vv"}, {U'n', "ri"}, {U'O', "Cl"}};
    for (const auto& [code, two] : kPairs) {
        if (code != one.code) continue;
        for (auto at = words.text.find(static_cast<char>(code)); at != std::string::npos;
             at = words.text.find(static_cast<char>(code), at + 1)) {
            std::string said = words.text;
            if (said.replace(at, 1, two) == other.text) return true;
        }
    }
    return false;
}

// Two letters that touch may look like one, which the other reader denies: "germanium" and "germanmm".
bool may_be_pair(const FormWords& words, const ReadWords& other) {
    constexpr double kLikeItself = 0.95;  // as letters of a font are that is the picture's
    if (words.agreed || other.text.empty()) return false;
    return std::any_of(words.reading.letters.begin(), words.reading.letters.end(), [&](const FormLetter& one) {
        return kLikeTwo.find(one.code) != kLikeTwo.npos &&
               (one.likeness < kClear || (one.likeness < kLikeItself && other.sure && is_said_as_two(one, words, other)));
    });
}

// In print of so few pixels two readers say the same wrong figure.
bool may_be_other_figure(const FormReading& reading) {
    constexpr std::u32string_view kAlikeFigures = U"3689";
    return reading.em < kSpeckPrint && std::any_of(reading.letters.begin(), reading.letters.end(), [&](const FormLetter& one) {
               return kAlikeFigures.find(one.code) != kAlikeFigures.npos;
           });
}

// Letters of any font bear out what the other reader says.
Belief believe_strange(const FormWords& words, const ReadWords& other) {
    const FormReading& reading = words.reading;
    const double least = reading.mean >= kLikeAny ? kSureStrange : kSureUnlike;
    const bool figure =
        std::none_of(reading.letters.begin(), reading.letters.end(), [](const FormLetter& one) { return is_of_words(one.code); });
    Belief belief{words.text, 100 * reading.mean, false, true};
    belief.sure = words.settled && ((other.sure && other.sureness >= least) || (figure && kBothSay.holds(reading))) &&
                  !may_be_figures(words.text, true) && !breaks_off(words.text) && !is_of_mixed_case(reading) &&
                  !is_of_either_case(reading);
    if (reading.em >= kSmallPrint) return belief;
    // There a hyphen is hardly narrower than a dash.
    const bool dash = std::any_of(reading.letters.begin(), reading.letters.end(),
                                  [](const FormLetter& one) { return one.code == '-' || one.code == kEnDash; });
    belief.sure = belief.sure && !dash && is_plain(words.text, other.text, true) && is_no_pair(words, other);
    return belief;
}

Belief believe_letters(const FormWords& words, const ReadWords& other) {
    const FormReading& reading = words.reading;
    if (words.text.empty()) {
        const bool borne_out = other.sureness >= kSureWords && bears_out(reading, other.text);
        Belief belief{other.text, other.sureness, other.sure && borne_out && !breaks_off(other.text), other.sure};
        return belief;
    }
    Belief belief{words.text, 100 * reading.mean, false, false};
    const auto& letters = reading.letters;
    const auto telling = static_cast<std::size_t>(std::count_if(letters.begin(), letters.end(), [](const FormLetter& one) {
        return is_word_letter(one.code) && !may_be_drawn(one.code);
    }));
    if (words.strange) return believe_strange(words, other);
    if (letters.size() < 2) {
        constexpr char32_t kGreek = 0x370, kAfterGreek = 0x400;
        constexpr double kSureGreek = 0.9;  // bent to few pixels, a Y is a γ
        const bool greek = letters.front().code >= kGreek && letters.front().code < kAfterGreek;
        const bool alike = telling > 0 && words.sized && is_alone_alike(reading) && (!greek || reading.mean >= kSureGreek);
        belief.sure = alike && words.settled && !reading.either;
        belief.tell = alike;
        belief.nearly = belief.sure && may_be_other_figure(reading);
        belief.sure = belief.sure && !belief.nearly;
        return belief;
    }
    const bool clear = words.settled && !reading.either, few = letters.size() <= 2;
    const bool denied = other.sure && !words.agreed;  // other letters were read, twice alike
    const bool both = words.agreed && words.settled;
    belief.sure = both && (few ? kBothSayOfFew : kBothSay).holds(reading);
    belief.sure = belief.sure || (both && other.sure && other.sureness >= kSureWords && reading.mean >= kBothSay.mean && !few);
    belief.sure = belief.sure || (both && words.sized && kSmallBothSay.holds(reading) && reading.margin >= kMargin);
    const double margin = denied ? kAgainstOther : kMargin;
    belief.sure = belief.sure || (clear && words.sized && telling > 0 && kOfKnownSize.holds(reading) && reading.margin >= margin);
    belief.sure = belief.sure || (clear && words.sized && telling > 0 && !denied && kSmallOfKnownSize.holds(reading) &&
                                  reading.margin >= kClearMargin);
    belief.sure = belief.sure || (clear && telling >= kLetters && kOfItself.holds(reading) && reading.margin >= margin);
    belief.tell = telling > 0 && kTold.holds(reading);
    // Nor does the other reader see by what print beside the line its size could be told; and no figure is a wrong word.
    const bool figure = std::all_of(letters.begin(), letters.end(), [](const FormLetter& one) { return !is_of_words(one.code); });
    if (reading.em < kSmallPrint && reading.either && !words.sized) belief.sure = false;
    if (is_of_either_case(reading) && !words.sized) belief.sure = false;  // nor does it tell "cos" from "COS"
    const bool unasked = reading.em < kTinyPrint && figure && other.text.empty();
    belief.nearly = belief.sure && (unasked || may_be_other_figure(reading));
    if (reading.em < kTinyPrint && figure && !kBothSay.holds(reading)) belief.sure = false;
    if (reading.em < kSmallPrint)
        belief.sure = belief.sure && is_plain(words.text, other.text, words.agreed) && is_no_pair(words, other);
    belief.sure = belief.sure && !may_be_pair(words, other) && !may_be_other_figure(reading) && !is_of_mixed_case(reading) &&
                  !breaks_off(words.text) && !may_be_figures(words.text, reading.mean < kOfItself.mean);
    return belief;
}

}  // namespace

bool has_pairs(std::string_view text) {
    int open = 0;
    bool ever = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool opens = text[i] == '(' || text[i] == '[', closes = text[i] == ')' || text[i] == ']';
        if (closes && open == 0) {
            const bool listed = !ever && i > 0 && (i == 1 || (i == 2 && (text[0] & 0x80) != 0));
            if (!listed) return false;
        } else
            open += (opens ? 1 : 0) - (closes ? 1 : 0);
        ever = ever || opens;
    }
    return open == 0;
}

Belief believe(const FormWords& words, const ReadWords& other) {
    Belief belief = believe_letters(words, other);
    belief.open = belief.sure && !has_pairs(belief.text);
    belief.sure = belief.sure && !belief.open;
    return belief;
}

bool is_degrees(std::string_view text) { return text == "\u00b0C" || text == "\u00b0F"; }

bool has_letter_for_figure(std::string_view text) {
    constexpr std::string_view kAlike = "OoIl|", kOfNumbers = "0123456789.,OoIl|";
    bool after_number = false;
    while (!text.empty()) {
        std::string_view part = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(part.size() + 1, text.size()));
        if (after_number && part == "Q") return true;
        if (part.size() > 2 && part[0] == 'l' && part.find_first_not_of("0123456789", 1) == part.npos) return true;  // "l00"
        std::string_view rest = part;
        if (!rest.empty() && is_dash(take_letter(rest))) part = rest;
        after_number = !part.empty() && is_digit(part.front());
        if (after_number && part.find_first_of(kAlike) != part.npos && part.find_first_not_of(kOfNumbers) == part.npos)
            return true;
    }
    return false;
}

bool ends_word_with_capital_i(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i)
        if (text[i] == 'I' && text[i - 1] >= 'a' && text[i - 1] <= 'z' && (i + 1 == text.size() || text[i + 1] == ' '))
            return true;
    return false;
}

bool names_letter_in_formula(std::string_view text) {
    bool equals = false, letter = false;
    while (!text.empty()) {
        const std::string_view part = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(part.size() + 1, text.size()));
        equals = equals || part == "=";
        letter = letter || (part.size() == 1 &&
                            (is_lower(static_cast<unsigned char>(part[0])) || is_upper(static_cast<unsigned char>(part[0]))));
    }
    return equals && letter;
}

bool begins_in_formula(std::string_view text) {
    constexpr std::string_view kBetween = "+=<>*/";
    return text.size() > 2 && kBetween.find(text[0]) != kBetween.npos && text[1] == ' ';
}

}  // namespace tactics
