// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/form_words.h"

#include <algorithm>
#include <cmath>

#include "tactics/lettering/picture_fonts.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// The figures of a font are as high as each other, whichever font that is.
class FigureHeights {
public:
    explicit FigureHeights(const std::vector<FormWords>& words) {
        for (const FormWords& one : words)
            if (one.agreed && one.settled && one.reading.letters.size() > 1)
                for (const FormLetter& letter : one.reading.letters)
                    if (is_digit(letter.code) && !letter.touches && letter.place == FormLetter::Place::on_line)
                        heights_.push_back(letter.box.height());
    }
    bool have(double own) const {
        return std::any_of(heights_.begin(), heights_.end(),
                           [&](double height) { return std::abs(height - own) <= 0.5 + 0.02 * height; });
    }

private:
    std::vector<double> heights_;
};

bool is_lone_figure(const FormReading& reading) { return reading.letters.size() == 1 && is_digit(reading.letters.front().code); }

}  // namespace

std::vector<FormWords> read_in_fonts(const std::vector<InkStrip>& strips, const std::vector<OtherReading>& others,
                                     const PrintFonts& fonts) {
    std::vector<FormWords> words(strips.size());
    PictureFonts picture(strips, others);
    if (!picture.choose(fonts)) return {};
    const auto is_lone = [&](std::size_t i) { return strips[i].units() < 2; };
    const auto waits = [&](std::size_t i) { return strips[i].has_veil(); };  // until sizes are known
    for (std::size_t i = 0; i < strips.size(); ++i)
        if (!is_lone(i) && !waits(i)) words[i] = picture.read(i);
    for (const FormWords& one : words)
        if (one.agreed && one.settled && !one.reading.either && !is_of_either_case(one.reading)) picture.know(one);
    const auto read_again = [&](std::size_t i) {
        if (is_lone(i) || words[i].reading.either || !words[i].sized || words[i].text.empty()) words[i] = picture.read(i);
        words[i].sized = words[i].font >= 0 && picture.knows(words[i]) && (!is_lone(i) || is_alone_alike(words[i].reading));
    };
    const auto read_all_again = [&](auto is) {
        for (std::size_t i = 0; i < strips.size(); ++i)
            if (!waits(i) && is(words[i])) read_again(i);
    };
    const auto is_any = [](const FormWords&) { return true; };
    const auto is_not_sized = [](const FormWords& one) { return !one.sized; };
    picture.bend();
    read_all_again(is_any);
    if (picture.add_formulas()) read_all_again([](const FormWords& one) { return one.text.empty() || !one.sized; });
    picture.know_by_company(words);
    read_all_again(is_not_sized);
    constexpr int kMostSizes = 3;      // of print that has no words
    constexpr std::size_t kShort = 4;  // pieces of ink, of numbers and letters
    for (int size = 0; size < kMostSizes; ++size) {
        std::vector<std::size_t> left;
        for (std::size_t i = 0; i < strips.size(); ++i)
            if (strips[i].units() <= kShort && !words[i].sized) left.push_back(i);
        if (!picture.choose_by_letters(left)) break;
        picture.bend();
        read_all_again(is_not_sized);
    }
    if (picture.choose_by_formulas()) read_all_again(is_any);
    for (std::size_t i = 0; i < strips.size(); ++i)
        if (waits(i)) read_again(i);
    for (std::size_t i = 0; i < strips.size(); ++i) picture.bear_out_in_any(i, words[i]);
    const FigureHeights heights(words);
    for (std::size_t i = 0; i < strips.size(); ++i) {
        FormWords& one = words[i];
        if (strips[i].units() != 1 || one.sized || !heights.have(strips[i].measure(0, 0).height())) continue;
        if (one.text.empty())
            one.reading.text = picture.figure_like(i);
        else
            one.sized = one.settled && is_lone_figure(one.reading) && is_alone_alike(one.reading);
    }
    return words;
}

}  // namespace tactics
