// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/agreement.h"

#include <algorithm>

#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings. Print that is bent to pixels, in fonts with serifs at 100 dpi, is like its letters with 0.79 to 0.92; letters that
// are none of the font seldom reach 0.7.
struct Likely {
    double mean, least;
    bool holds(const FormReading& reading) const { return reading.mean >= mean && reading.least >= least; }
};
constexpr Likely kBothSay{0.8, 0.7}, kBothSayOfFew{0.84, 0.78}, kOfKnownSize{0.85, 0.74}, kOfItself{0.93, 0.85},
    kAlone{0.86, 0.86}, kTold{0.75, 0.6};
constexpr std::size_t kLetters = 4;  // that many are no accident
constexpr double kSureWords = 88;    // of 100: leaves and stones are read as words with less
constexpr double kBearsOut = 0.72;   // of a letter

bool is_word_letter(char32_t code) {
    return (code >= '0' && code <= '9') || ((code | 32) >= 'a' && (code | 32) <= 'z') || code >= 0x80;
}

// The pieces that are like letters are letters of that text, in its order, and what is left of it are letters, too: a figure or a
// point may be anything.
bool bears_out(const FormReading& reading, std::string_view text) {
    constexpr double kShare = 0.6;
    std::vector<char32_t> letters;
    while (!text.empty())
        if (const char32_t letter = take_letter(text); letter != ' ') letters.push_back(letter);
    std::size_t at = 0, found = 0, passed = 0, unlike = 0;
    bool plain = true;
    const auto pass = [&] {
        ++passed;
        plain = plain && (letters[at] | 32) >= 'a' && (letters[at] | 32) <= 'z';
        ++at;
    };
    for (const FormLetter& letter : reading.letters) {
        if (letter.code == 0 || letter.likeness < kBearsOut) {
            ++unlike;
            continue;
        }
        if (letter.place != FormLetter::Place::on_line) return false;  // which the text does not say
        const auto is = [&](char32_t code) {
            return code == letter.code || std::find(letter.alike.begin(), letter.alike.end(), code) != letter.alike.end();
        };
        while (at < letters.size() && !is(letters[at])) pass();
        if (at == letters.size()) return false;
        ++at;
        ++found;
    }
    while (at < letters.size()) pass();
    if (unlike > 0 && passed == 0) return false;  // a point, which the text has not
    return plain && !letters.empty() && static_cast<double>(found) >= kShare * static_cast<double>(letters.size());
}

}  // namespace

Belief believe(const FormWords& words, const ReadWords& other) {
    const FormReading& reading = words.reading;
    if (words.text.empty()) {
        const bool borne_out = bears_out(reading, other.text);
        return {other.text, other.sureness, other.sure && borne_out, other.sure};
    }
    Belief belief{words.text, 100 * reading.mean, false, false};
    const auto& letters = reading.letters;
    const auto telling = static_cast<std::size_t>(std::count_if(letters.begin(), letters.end(), [](const FormLetter& one) {
        return is_word_letter(one.code) && !may_be_drawn(one.code);
    }));
    if (letters.size() < 2) {
        belief.sure = telling > 0 && words.sized && words.settled && !reading.either && kAlone.holds(reading);
        belief.tell = telling > 0 && words.sized && kAlone.holds(reading);
        return belief;
    }
    const bool clear = words.settled && !reading.either;
    belief.sure = words.agreed && words.settled && (letters.size() > 2 ? kBothSay : kBothSayOfFew).holds(reading);
    belief.sure = belief.sure || (words.agreed && words.settled && other.sure && other.sureness >= kSureWords &&
                                  reading.mean >= kBothSay.mean && letters.size() > 2);
    belief.sure = belief.sure || (clear && words.sized && telling > 0 && kOfKnownSize.holds(reading));
    belief.sure = belief.sure || (clear && telling >= kLetters && kOfItself.holds(reading));
    belief.tell = telling > 0 && kTold.holds(reading);
    return belief;
}

}  // namespace tactics
