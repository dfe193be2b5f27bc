// SPDX-License-Identifier: Apache-2.0
// The few fonts of a picture's print, and the sizes in which it has them.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tactics/lettering/form_line.h"

namespace tactics {

/// The likeness of a line to letters of a font that needs no other witness, and by how much of an em sizes may differ that are
/// one. Settings.
inline constexpr double kFitsAlone = 0.92, kSameSize = 0.06;

/// Lines of a picture and what another reader made of them; both outlive it.
class PictureFonts {
public:
    PictureFonts(const std::vector<InkStrip>& strips, const std::vector<OtherReading>& others)
        : strips_(strips), others_(others) {}

    /// False: there is none.
    bool choose(const PrintFonts& fonts);

    /// A line in the chosen font that it fits best.
    FormWords read(std::size_t line);

    /// Words that another reader was sure of, in print that no chosen font bears out: any fonts may, letter by letter.
    void bear_out_in_any(std::size_t line, FormWords& words);

    /// Their size is one of their font's.
    void know(const FormWords& words);
    bool knows(const FormWords& words) const;

    /// Small letters that were bent to the pixels are like themselves only when bent in the same way.
    void bend();

    /// What the letters of a chosen font do not read may be a formula in it. False: no font has any.
    bool add_formulas();

    /// A size that enough letters have which its words read without the other reader.
    void know_by_company(const std::vector<FormWords>& words);

    /// Short print of unknown size, such as the numbers of an axis in a font that no words have: it belongs to a font that three
    /// of its letters match, as they are or as formulas have them, in one size, or more of them less well, as letters that were
    /// bent to the pixels do.
    bool choose_by_letters(const std::vector<std::size_t>& lines);

    /// Where neither words nor letters tell a font, one that reads a formula without doubt. False: there is none.
    bool choose_by_formulas();

    /// The figure that a lone letter looks like most in the fonts that fit the words best, for an axis to bear it out.
    std::string figure_like(std::size_t line);

private:
    // Of the words that tell one font from another, and figures; reading takes longer for all letters of all fonts.
    std::vector<char32_t> letters_asked_for() const;

    std::vector<FormFont*> all_fonts();

    void add_bent(std::size_t font, double em);

    // Its letters with those of formulas.
    FontShapes with_slanted(std::size_t font, const FontShapes& formula);

    // In another form, of the same sizes.
    void add(std::size_t font, FontShapes shapes);

    // The font that fits the words best; then fonts that fit some of them much better.
    void choose_by_words(const std::vector<std::size_t>& lines);

    // If the other reading fits no font, a font that reads one of the lines without doubt disproves it.
    void choose_by_looks();

    // Some lines of so many letters that they tell a font.
    template <typename Is>
    std::vector<std::size_t> telling_lines(Is is) const {
        constexpr std::size_t kMostLines = 4, kLetters = 4, kMostLetters = 24;
        std::vector<std::size_t> lines;
        for (std::size_t i = 0; i < strips_.size() && lines.size() < kMostLines; ++i)
            if (strips_[i].units() >= kLetters && strips_[i].units() <= kMostLetters && is(i)) lines.push_back(i);
        return lines;
    }

    // Of short print, if letters of one size are told by it: how well they fit, and the size; else zeros. `known`: other print
    // has that font.
    std::pair<double, double> size_told_by(const std::vector<std::size_t>& samples, FormFont& font, bool known) const;

    // Of one height, as numbers are, and then of others that letters of that size may have; of those that are all the same, as
    // dots are, one.
    std::vector<std::size_t> samples_of(const std::vector<std::size_t>& lines) const;

    const std::vector<InkStrip>& strips_;
    const std::vector<OtherReading>& others_;
    std::vector<FormFont> fonts_;    // as they are, then bent ones and those of formulas
    std::vector<std::size_t> base_;  // of each the one that it is, as it is
    std::vector<decltype(PrintFont::bent)> bent_;
    std::vector<decltype(PrintFont::formula)> formulas_;
    std::set<std::pair<std::size_t, double>> bends_;  // font and size
    std::vector<std::size_t> by_fit_;                 // all as they are, the one that fits the words best first
    std::vector<std::size_t> chosen_;
    std::vector<std::vector<double>> sizes_;  // known sizes of each font, pixels per em
    struct Widths {
        double em;              // that they were read in
        double is = 0, of = 0;  // of letters, pixels; of their forms, em
    };
    std::vector<std::vector<Widths>> widths_;  // of each font's lines of known size
};

}  // namespace tactics
