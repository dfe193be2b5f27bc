// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tactics/lettering/form_reader.h"
#include "tactics/text/utf8.h"

namespace tactics {

double likeness_to(const InkStrip& strip, FormFont& font, std::string_view text, double& em) {
    std::vector<char32_t> codes;
    const std::string_view guess = text;
    while (!text.empty())
        if (const char32_t code = take_letter(text); code != ' ') codes.push_back(code);
    if (codes.empty() || strip.units() == 0) return 0;
    if (codes.size() != strip.units()) {
        const FormReading reading = read_by_forms(strip, font, {}, guess, true);
        const bool same = std::equal(codes.begin(), codes.end(), reading.letters.begin(), reading.letters.end(),
                                     [](char32_t code, const FormLetter& letter) { return letter.may_be(code); });
        em = reading.em;
        return same ? reading.mean : 0;
    }
    double sum = 0, width = 0;
    std::vector<double> sizes;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const LetterForm& form = font.form(codes[i]);
        const InkBox box = strip.measure(i, i);
        width += box.width();
        if (form.empty() || !(box.height() > 0)) continue;
        sum += box.width() * LetterInk(strip, i, i, box).likeness(font.drawn(codes[i]));
        if (form.height() >= 0.4) sizes.push_back(box.height() / form.height());
    }
    if (sizes.empty() || !(width > 0)) return 0;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    em = *middle;
    // Letters of one line are of one size.
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const LetterForm& form = font.form(codes[i]);
        const InkBox box = strip.measure(i, i);
        const double off = std::abs(box.width() - form.width() * em);
        if (!form.empty() && off > 1.2 + 0.08 * box.width()) sum -= 0.5 * std::min(off, box.width());
    }
    return std::max(0.0, sum / width);
}

}  // namespace tactics
