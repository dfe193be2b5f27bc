// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/alignment.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

// Settings. Likeness that counts for nothing; how far widths and heights of letters of another font may be off; of how many units
// a letter may consist, and how many letters may touch.
constexpr double kLikeNothing = 0.15, kSpeckLike = 0.1;
constexpr double kWidthOff = 0.3, kHeightOff = 0.3, kPixelsOff = 1.5;
constexpr std::size_t kMostStrokes = 4, kMostTouching = 4, kMostAligned = 90;

class Aligner {
public:
    Aligner(const InkStrip& strip, FormFont& font, const std::u32string& letters)
        : strip_(strip), font_(font), letters_(letters), columns_(strip.units() + 1), steps_((letters.size() + 1) * columns_) {}

    std::optional<AlignedLine> run() {
        if (!measure()) return std::nullopt;
        steps_[0].value = 0;
        for (std::size_t i = 0; i < letters_.size(); ++i)
            for (std::size_t u = 0; u < strip_.units(); ++u) {
                if (step(i, u).value < 0) continue;
                for (std::size_t k = 1; k <= std::min(kMostStrokes, strip_.units() - u); ++k) go(i, u, 1, k);
                for (std::size_t k = 2; k <= std::min(kMostTouching, letters_.size() - i); ++k) go(i, u, k, 1);
            }
        if (step(letters_.size(), strip_.units()).value < 0) return std::nullopt;
        return result();
    }

private:
    struct Step {
        double value = -1;  // the best there; less than 0: there is no way
        std::size_t letters = 0, units = 0;
        double likeness = 0;  // of the last step
    };
    Step& step(std::size_t letter, std::size_t unit) { return steps_[letter * columns_ + unit]; }

    // The size, from the highest and the lowest letter.
    bool measure() {
        double top = -1, bottom = 1;
        for (const char32_t code : letters_) {
            const LetterForm& form = font_.form(code);
            if (form.empty()) return false;
            top = std::max(top, form.top());
            bottom = std::min(bottom, form.bottom());
        }
        const InkBox all = strip_.measure(0, strip_.units() - 1);
        if (!(all.height() > 0) || !(top > bottom)) return false;
        em_ = all.height() / (top - bottom);
        foot_ = all.top + top * em_;
        return true;
    }

    bool fits(const InkBox& box, const LetterForm& form) const {
        const auto near = [&](double is, double wanted, double off) {
            return std::abs(is - wanted) <= kPixelsOff + off * wanted;
        };
        return near(box.width(), form.width() * em_, kWidthOff) && near(box.height(), form.height() * em_, kHeightOff) &&
               near(foot_ - box.bottom, form.bottom() * em_, 0);
    }

    void go(std::size_t letter, std::size_t unit, std::size_t letters, std::size_t units) {
        const char32_t code = letters == 1 ? letters_[letter] : font_.join(letters_.substr(letter, letters));
        const LetterForm& form = font_.form(code);
        const InkBox box = strip_.measure(unit, unit + units - 1);
        if (form.empty() || !(box.width() > 0) || !(box.height() > 0) || !fits(box, form)) return;
        const double least = form.height() < kLowForm ? kSpeckLike : kLikeNothing;
        const double likeness = LetterInk(strip_, unit, unit + units - 1, box).likeness(font_.drawn(code), least);
        const double value = step(letter, unit).value + (likeness - least) * box.width();
        Step& to = step(letter + letters, unit + units);
        if (likeness >= least && value > to.value) to = {value, letters, units, likeness};
    }

    AlignedLine result() {
        AlignedLine found{em_, foot_, 0, {}};
        double width = 0;
        for (std::size_t i = letters_.size(), u = strip_.units(); i > 0 && u > 0;) {
            const Step& last = step(i, u);
            i -= last.letters;
            u -= last.units;
            const InkBox box = strip_.measure(u, u + last.units - 1);
            width += box.width();
            found.likeness += last.likeness * box.width();
            add(found, i, last.letters, {0, u, u + last.units - 1, last.letters > 1, box, last.likeness});
        }
        found.likeness /= width;
        std::reverse(found.letters.begin(), found.letters.end());
        refine(found);
        return found;
    }

    // From the last to the first, each with its part of what they share.
    void add(AlignedLine& found, std::size_t first, std::size_t count, AlignedLetter ink) const {
        double all = 0, before = 0;
        for (std::size_t k = 0; k < count; ++k) all += font_.form(letters_[first + k]).advance();
        for (std::size_t k = count; k-- > 0; before += font_.form(letters_[first + k]).advance()) {
            AlignedLetter one = ink;
            one.code = letters_[first + k];
            if (count > 1) {
                one.box.right = ink.box.right - before / all * ink.box.width();
                one.box.left = one.box.right - font_.form(one.code).advance() / all * ink.box.width();
            }
            found.letters.push_back(one);
        }
    }

    // By most letters, whose highest and lowest may be others in this font.
    void refine(AlignedLine& found) {
        constexpr double kTall = 0.4;  // em; what is lower tells no size
        std::vector<double> sizes, feet;
        for (const AlignedLetter& one : found.letters)
            if (const LetterForm& form = font_.form(one.code); !one.shared && form.height() >= kTall)
                sizes.push_back(one.box.height() / form.height());
        if (sizes.empty()) return;
        const auto middle = [](std::vector<double>& values) {
            const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::nth_element(values.begin(), at, values.end());
            return *at;
        };
        found.em = middle(sizes);
        for (const AlignedLetter& one : found.letters)
            if (!one.shared) feet.push_back(one.box.bottom + font_.form(one.code).bottom() * found.em);
        found.foot = middle(feet);
    }

    const InkStrip& strip_;
    FormFont& font_;
    const std::u32string& letters_;
    std::size_t columns_;
    std::vector<Step> steps_;
    double em_ = 0, foot_ = 0;
};

}  // namespace

std::optional<AlignedLine> align(const InkStrip& strip, FormFont& font, const std::u32string& letters) {
    if (letters.empty() || strip.units() == 0 || letters.size() > kMostAligned || strip.units() > 2 * kMostAligned)
        return std::nullopt;
    return Aligner(strip, font, letters).run();
}

}  // namespace tactics
