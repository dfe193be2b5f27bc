// SPDX-License-Identifier: Apache-2.0
// What letters that were found say, in order.

#include <utility>

#include "tactics/lettering/form_reader.h"
#include "tactics/text/formula_letters.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kWordSpace = 0.14;  // em

// Letters of one place, as exponents and indices are.
class PlacedText {
public:
    void add(FormLetter::Place place, char32_t code) {
        if (place != place_) flush();
        place_ = place;
        letters_ += code;
    }
    void space() {
        flush();
        text_ += ' ';
    }
    bool empty() const { return text_.empty() && letters_.empty(); }
    std::string take() {
        flush();
        return std::move(text_);
    }

private:
    void flush() {
        if (letters_.empty()) return;
        if (place_ == FormLetter::Place::raised)
            append_raised(text_, letters_);
        else if (place_ == FormLetter::Place::lowered)
            append_lowered(text_, letters_);
        else
            for (const char32_t letter : letters_) append_letter(text_, letter);
        letters_.clear();
    }

    std::string text_;
    std::u32string letters_;
    FormLetter::Place place_ = FormLetter::Place::on_line;
};

}  // namespace

std::string text_of(const FormReading& reading, FormFont& font) {
    PlacedText text;
    double end = 0;
    for (const FormLetter& letter : reading.letters) {
        const LetterForm& form = font.form(letter.slanted ? slanted(letter.code) : letter.code);
        if (form.empty()) continue;
        const double em = letter.place == FormLetter::Place::on_line ? reading.em : letter.box.height() / form.height();
        const double start = letter.box.left - form.left() * em;
        if (!text.empty() && start - end > kWordSpace * reading.em) text.space();
        text.add(letter.place, letter.code);
        end = start + form.advance() * em;
    }
    return to_line(text.take());
}

}  // namespace tactics
