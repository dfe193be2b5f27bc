// SPDX-License-Identifier: Apache-2.0
// What letters that were found say, in order.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "tactics/lettering/form_reader.h"
#include "tactics/text/formula_letters.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kWordSpace = 0.14, kThinSpace = 0.21;  // em; TeX leaves 1/6 around the names of functions

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

const LetterForm& form_of(const FormLetter& letter, FormFont& font) {
    return font.form(letter.slanted ? slanted(letter.code) : letter.code);
}

// Before each letter, beyond what the font leaves between two, em.
std::vector<double> gaps_of(const FormReading& reading, FormFont& font) {
    std::vector<double> gaps;
    std::optional<double> end;
    for (const FormLetter& letter : reading.letters) {
        gaps.push_back(0);
        const LetterForm& form = form_of(letter, font);
        if (form.empty()) continue;
        const double em = letter.place == FormLetter::Place::on_line ? reading.em : letter.box.height() / form.height();
        const double start = letter.box.left - form.left() * em;
        if (end) gaps.back() = (start - *end) / reading.em;
        end = start + form.advance() * em;
    }
    return gaps;
}

}  // namespace

std::string text_of(const FormReading& reading, FormFont& font) {
    PlacedText text;
    const std::vector<double> gaps = gaps_of(reading, font);
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        const FormLetter& letter = reading.letters[i];
        if (form_of(letter, font).empty()) continue;
        if (!text.empty() && gaps[i] > kWordSpace) text.space();
        text.add(letter.place, letter.code);
    }
    return to_line(text.take());
}

bool has_thin_spaces(const FormReading& reading, FormFont& font) {
    const std::vector<double> gaps = gaps_of(reading, font);
    const double widest = gaps.empty() ? 0 : *std::max_element(gaps.begin(), gaps.end());
    return widest > kWordSpace && widest < kThinSpace;
}

}  // namespace tactics
