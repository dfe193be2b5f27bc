// SPDX-License-Identifier: Apache-2.0
// What letters that were found say, in order.

#include "tactics/lettering/form_reader.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kWordSpace = 0.14;  // em

void append_placed(std::string& text, const FormLetter& letter) {
    char32_t code = 0;
    if (letter.place == FormLetter::Place::raised) code = raised(letter.code);
    if (letter.place == FormLetter::Place::lowered && is_digit(letter.code)) code = lowered(letter.code);
    append_letter(text, code != 0 ? code : letter.code);
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
