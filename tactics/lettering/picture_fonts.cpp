// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/picture_fonts.h"

#include <algorithm>
#include <cmath>

#include "tactics/lettering/meant_letters.h"
#include "tactics/lettering/strange_print.h"
#include "tactics/text/formula_letters.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings, of words that two readers say.
constexpr double kFitsBoth = 0.8, kLeastOfBoth = 0.7;

bool is_figure(const std::string& text) { return text.find_first_not_of("0123456789.,") == text.npos; }

// Of a figure the font knows its gaps better.
void keep_gaps(FormWords& words, const std::string& other) {
    if (is_figure(words.text)) return;
    if (const auto text = with_its_gaps(words.reading, words.text, with_letters(other, words.reading)))
        words.text = *text;
    else
        words.settled = false;
}

}  // namespace

FormWords PictureFonts::read(std::size_t line) {
    FormWords best;
    for (const std::size_t font : chosen_) {
        FormReading reading = read_by_forms(strips_[line], fonts_[font], sizes_[base_[font]], others_[line].text);
        if (reading.letters.empty() || (best.font >= 0 && reading.value <= best.reading.value)) continue;
        best.reading = std::move(reading);
        best.font = static_cast<int>(font);
    }
    if (best.font < 0) return best;
    const std::size_t font = std::exchange(best.font, static_cast<int>(base_[static_cast<std::size_t>(best.font)]));
    if (best.reading.text.empty()) return best;
    settle(best, others_[line]);
    best.text = text_of(best.reading, fonts_[font]);
    best.thin = has_thin_spaces(best.reading, fonts_[font]);
    const std::string& other = others_[line].text;
    best.agreed = others_[line].alike && (same_letters(best.text, other) || same_but_for_signs(best.text, other));
    if (best.agreed && best.text != other && best.reading.mean < kFitsAlone) keep_gaps(best, other);
    return best;
}

void PictureFonts::bear_out_in_any(std::size_t line, FormWords& words) {
    const OtherReading& other = others_[line];
    if (strips_[line].veiled(0, strips_[line].units() - 1)) return;
    const bool fits = words.reading.mean >= kFitsBoth && words.reading.least >= kLeastOfBoth;
    // Small print of a known font has its own rules.
    if (!other.alike || (words.agreed && ((words.settled && fits) || words.reading.em < kSmallPrint))) return;
    const auto reading = bear_out(strips_[line], other.text, all_fonts());
    if (reading && (words.text.empty() || same_letters(words.text, other.text) || reading->mean > words.reading.mean)) {
        words.reading = *reading;
        settle(words, other);
        words.settled = words.settled && !reading->text.empty();
        words.text = with_letters(other.text, words.reading);
        words.sized = false;
        words.agreed = words.strange = true;
    }
}

bool PictureFonts::knows(const FormWords& words) const {
    const auto& sizes = sizes_[static_cast<std::size_t>(words.font)];
    const double em = words.reading.em;
    return std::any_of(sizes.begin(), sizes.end(), [&](double one) { return std::abs(one - em) <= kSameSize * em + 0.3; });
}

void PictureFonts::know(const FormWords& words) {
    const auto font = static_cast<std::size_t>(words.font);
    sizes_[font].push_back(words.reading.em);
    Widths widths{words.reading.em};
    for (const FormLetter& letter : words.reading.letters) {
        const LetterForm& form = fonts_[font].form(letter.code);
        if (form.empty() || letter.touches || letter.slanted || letter.place != FormLetter::Place::on_line) continue;
        widths.is += letter.box.width();
        widths.of += form.width();
    }
    if (widths.of > 0) widths_[font].push_back(widths);
}

// Letters are bent upwards and downwards only, so that their widths tell which size they have.
void PictureFonts::bend() {
    constexpr double kMostBent = 20, kOneSize = 0.05;  // pixels for an em; of that
    const std::vector<std::size_t> chosen = chosen_;
    for (const std::size_t font : chosen) {
        if (base_[font] != font || !bent_[font]) continue;
        std::vector<Widths> lines = widths_[font];
        std::sort(lines.begin(), lines.end(), [](const Widths& a, const Widths& b) { return a.em < b.em; });
        for (std::size_t i = 0, end = 0; i < lines.size() && lines[i].em < kMostBent; i = end) {
            Widths all{0};
            for (; end < lines.size() && lines[end].em <= (1 + kOneSize) * lines[i].em; ++end) {
                all.is += lines[end].is;
                all.of += lines[end].of;
            }
            add_bent(font, all.is / all.of);
        }
    }
}

bool PictureFonts::add_formulas() {
    const std::vector<std::size_t> chosen = chosen_;
    for (const std::size_t font : chosen)
        if (base_[font] == font && formulas_[font])
            add(font, with_slanted(font, std::exchange(formulas_[font], {})(letters_of_figures())));
    return chosen_.size() > chosen.size();
}

std::string PictureFonts::figure_like(std::size_t line) {
    constexpr double kLeastLike = 0.6, kOffWidth = 0.2;  // settings; of its height
    constexpr std::size_t kLikelyFonts = 24;
    const InkBox box = strips_[line].measure(0, 0);
    LetterInk ink(strips_[line], 0, 0, box);
    double best = kLeastLike;
    std::string figure;
    for (std::size_t f = 0; f < std::min(kLikelyFonts, by_fit_.size()); ++f)
        for (char32_t code = '0'; code <= '9'; ++code) {
            FormFont& font = fonts_[by_fit_[f]];
            const LetterForm& form = font.form(code);
            if (form.empty() || std::abs(box.width() / box.height() - form.width() / form.height()) > kOffWidth) continue;
            const double likeness = ink.likeness(font.drawn(code), best);
            if (likeness <= best) continue;
            best = likeness;
            figure = static_cast<char>(code);
        }
    return figure;
}

std::vector<char32_t> PictureFonts::letters_asked_for() const {
    std::set<char32_t> letters;
    for (const char figure : std::string_view("0123456789")) letters.insert(static_cast<unsigned char>(figure));
    for (const std::u32string_view pair : kLikeOne) letters.insert(pair.begin(), pair.end());
    for (const OtherReading& other : others_)
        for (std::string_view rest = other.text; !rest.empty();) letters.insert(take_letter(rest));
    return {letters.begin(), letters.end()};
}

std::vector<FormFont*> PictureFonts::all_fonts() {
    std::vector<FormFont*> fonts;
    for (const std::size_t f : by_fit_) fonts.push_back(&fonts_[f]);
    return fonts;
}

void PictureFonts::add_bent(std::size_t font, double em) {
    em = std::round(10 * em) / 10;
    if (!bends_.insert({font, em}).second) return;
    add(font, bent_[font](letters_of_figures(), em));
}

FontShapes PictureFonts::with_slanted(std::size_t font, const FontShapes& formula) {
    if (formula.empty()) return {};
    FontShapes all = fonts_[font].shapes();
    for (const auto& [code, shape] : formula)
        if (slanted(code) != code) all[slanted(code)] = shape;
    return all;
}

void PictureFonts::add(std::size_t font, FontShapes shapes) {
    if (shapes.empty()) return;
    chosen_.push_back(fonts_.size());
    base_.push_back(font);
    fonts_.emplace_back(std::move(shapes));
}

}  // namespace tactics
