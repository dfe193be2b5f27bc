// SPDX-License-Identifier: Apache-2.0
// What letters that were found say, in order.
#include <array>

#include "tactics/lettering/form_reader.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kWordSpace = 0.14;  // em

void append_placed(std::string& text, const FormLetter& letter) {
    constexpr std::array<char32_t, 10> kRaised{0x2070, 0xB9, 0xB2, 0xB3, 0x2074, 0x2075, 0x2076, 0x2077, 0x2078, 0x2079};
    const bool digit = is_digit(letter.code);
    if (letter.place == FormLetter::Place::raised && (digit || is_minus(letter.code)))
        append_letter(text, digit ? kRaised[letter.code - '0'] : 0x207B);
    else if (letter.place == FormLetter::Place::lowered && digit)
        append_letter(text, 0x2080 + (letter.code - '0'));
    else
        append_letter(text, letter.code);
}

}  // namespace

std::string text_of(const FormReading& reading, FormFont& font) {
    std::string text;
    double end = 0;
    for (const FormLetter& letter : reading.letters) {
        const LetterForm& form = font.form(letter.code);
        if (form.empty()) continue;
        const double em = letter.place == FormLetter::Place::on_line ? reading.em : letter.box.height() / form.height();
        const double start = letter.box.left - form.left() * em;
        if (!text.empty() && start - end > kWordSpace * reading.em) text += ' ';
        append_placed(text, letter);
        end = start + form.advance() * em;
    }
    return to_line(text);
}

}  // namespace tactics
