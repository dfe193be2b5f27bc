// SPDX-License-Identifier: Apache-2.0
// Shapes of letters that are of one font and size: which font that is, and which letters.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "print/letters.h"
#include "tactics/job/outline_measure.h"

namespace tactics {

struct FontLetter {
    char32_t code;
    double advance;  ///< em
    OutlineMeasure outline;
};

/// Those of `letters` that have ink, in that order.
std::vector<FontLetter> measured(const std::map<char32_t, Letter>& letters, const std::vector<char32_t>& order);

/// False for a font of signs, which has them at the places of letters.
bool has_letters(const std::vector<FontLetter>& font);

/// 'g' Greek, 'c' Cyrillic, 'l' all else.
char script_of(char32_t code);

/// By how much an em may differ from what candidates say, as a share.
inline constexpr double kBentSize = 0.04;

/// A font that a set may be of, whose letters were bent to pixels.
struct NearFont {
    std::size_t font = 0, shapes = 0;
    double em = 0, apart = 0;  // units; em, all together
    bool operator<(const NearFont& other) const { return shapes != other.shapes ? shapes > other.shapes : apart < other.apart; }
};

/// Of each shape of the figure what it may be: letters that look the same. Empty: not known.
using LettersOfShapes = std::vector<std::vector<FontLetter>>;

class ShapeSet {
public:
    /// `own` are the numbers of its shapes among `outlines`.
    ShapeSet(const std::vector<OutlineMeasure>& outlines, std::vector<std::size_t> own);

    /// Looks for its shapes among the letters of the font with that number. True: this is it.
    bool matches(const std::vector<FontLetter>& font, std::size_t number);
    /// The same, if its em is exactly that many units.
    bool matches_at(const std::vector<FontLetter>& font, double em);
    /// The best of the fonts that came near, or the one that matched.
    const std::vector<NearFont>& candidates() const { return candidates_; }
    /// Letters that some shape may be when it is bent to pixels.
    std::vector<char32_t> near(const std::vector<FontLetter>& font, double em) const;

    /// The letters of the font that matched last for shapes that have none yet.
    void take(const std::vector<FontLetter>& font, LettersOfShapes& read) const;
    /// None is left without a letter.
    bool is_read(const LettersOfShapes& read) const;

private:
    std::vector<std::size_t> own_;
    std::vector<OutlineMeasure> outlines_;
    std::vector<NearFont> candidates_;
    double em_ = 0;
};

}  // namespace tactics
