// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/veiled_letter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tactics/lettering/alike_letters.h"
#include "tactics/text/formula_letters.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings. Likeness of the letter, by how much it is more likely than any other, and how much of its ink is seen.
constexpr double kLeastIfVeiled = 0.7, kClearlyMore = 0.12, kLeastSeen = 0.6;
constexpr double kOff = 1.3;  // pixels; what is seen of a letter may reach out of it by so much
constexpr int kMostPlaces = 8;

constexpr char32_t kPlain = 0x80;  // other letters are too many to be told by parts

struct VeiledChoice {
    char32_t code = 0;
    double likeness = 0, seen = 0;
    InkBox box = {};
};

// They look like each other, seen whole, too, as an n and an eta do.
bool are_alike(char32_t one, char32_t other) {
    if (other >= kPlain) return true;
    return (is_dash(one) && is_dash(other)) || is_same_in_two_sizes(one, other) || is_same_in_two_sizes(other, one);
}

// Neighbouring units of a strip, to be held against letters of a known size.
struct Seen {
    const InkStrip& strip;
    std::size_t first, last;
    double em, foot;
    InkBox box = strip.measure(first, last);
};

// Where it looks most like the letter: what is seen of it lies within that.
VeiledChoice at_best_place(const Seen& seen, char32_t code, const LetterForm& form) {
    VeiledChoice best{code};
    const double width = form.width() * seen.em, bottom = seen.foot - form.bottom() * seen.em,
                 top = bottom - form.height() * seen.em;
    if (seen.box.top < top - kOff || seen.box.bottom > bottom + kOff || seen.box.width() > width + kOff) return best;
    const double from = seen.box.right - width, to = seen.box.left;
    const int places = std::clamp(static_cast<int>(std::ceil(std::abs(to - from))), 1, kMostPlaces);
    for (int i = 0; i <= places; ++i) {
        const double left = from + (to - from) * i / places;
        const InkBox box{left, top, left + width, bottom};
        LetterInk ink(seen.strip, seen.first, seen.last, box);
        const double likeness = ink.likeness(form, std::max(kLeastIfVeiled - kClearlyMore, best.likeness));
        if (likeness > best.likeness) best = {code, likeness, ink.seen(), box};
    }
    return best;
}

// The likeliest first; an accent that may be hidden, or be what is drawn, is none.
std::vector<VeiledChoice> choices_of(const Seen& seen, FormFont& font) {
    std::vector<VeiledChoice> choices;
    for (const auto& [code, shape] : font.shapes())
        if (!font.form(code).empty())
            if (const VeiledChoice choice = at_best_place(seen, code, font.drawn(code)); choice.likeness > 0)
                choices.push_back(choice);
    std::stable_sort(choices.begin(), choices.end(),
                     [](const VeiledChoice& a, const VeiledChoice& b) { return a.likeness > b.likeness; });
    const auto plain =
        std::find_if(choices.begin(), choices.end(), [](const VeiledChoice& one) { return !is_accented(one.code); });
    if (plain != choices.end() && plain->likeness >= choices.front().likeness - kClearlyMore)
        std::rotate(choices.begin(), plain, plain + 1);
    return choices;
}

}  // namespace

FormLetter veiled_letter(const InkStrip& strip, std::size_t first, std::size_t last, FormFont& font, double em, double foot) {
    const Seen seen{strip, first, last, em, foot};
    FormLetter letter;
    letter.box = seen.box;
    const std::vector<VeiledChoice> choices = choices_of(seen, font);
    if (choices.empty() || choices.front().likeness < kLeastIfVeiled || choices.front().seen < kLeastSeen) return letter;
    const VeiledChoice& best = choices.front();
    const char32_t code = plain_code(best.code);
    if (code >= kPlain) return letter;
    for (const VeiledChoice& choice : choices) {
        const char32_t other = plain_code(choice.code);
        if (other == code || is_accented(other)) continue;
        const double behind = best.likeness - choice.likeness;
        if (behind > kClearlyMore)
            letter.margin = std::min(letter.margin, behind);
        else if (are_alike(code, other))
            letter.alike.push_back(other);
        else
            return letter;
    }
    letter.code = code;
    letter.slanted = code != best.code;
    letter.likeness = best.likeness;
    letter.box = best.box;
    return letter;
}

}  // namespace tactics
