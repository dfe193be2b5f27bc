// SPDX-License-Identifier: Apache-2.0
// Letter shapes of one font and size: identifies the font and the letters.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "print/letters.h"
#include "tactics/job/outline_measure.h"

namespace tactics {

struct FontLetter {
    char32_t code;
    double advance;  ///< em
    double left;     ///< em, from where it begins to its ink
    OutlineMeasure outline;
};

/// Units of an em, if the shape is that letter.
double em_of(const OutlineMeasure& shape, const FontLetter& letter);

/// The `letters` that have ink, in that order.
std::vector<FontLetter> measured(const std::map<char32_t, Letter>& letters, const std::vector<char32_t>& order);

/// False for a symbol font, which has signs in place of letters.
bool has_letters(const std::vector<FontLetter>& font);

/// Of Latin, Greek or Cyrillic script.
bool is_alphabetic(char32_t code);

/// 'g' Greek, 'c' Cyrillic, 'l' everything else.
char script_of(char32_t code);

/// Of em: how far numbers of the same outline may lie apart (files write hundredths of a pixel, fonts have 1000 or 2048 units).
inline constexpr double kSameOutline = 0.006;

/// Those of the font that are apart by no more than that, by the distance given: in each script, for Α may be Greek, the nearest.
std::vector<FontLetter> letters_like(const std::vector<FontLetter>& font, const std::function<double(const FontLetter&)>& apart);

/// The letter of a font that is nearly the same in that size, beside letters of it: another edition has another dot on its i, and
/// TeX has the minus sign in a font of signs, whose bar has other ends. Nothing: none is, or two may be.
const FontLetter* nearly_same(const std::vector<FontLetter>& font, const OutlineMeasure& shape, double em);

/// Tolerated deviation of an em from that of the candidates, as a share.
inline constexpr double kBentSize = 0.04;

/// A possible font of a set, whose letters were hinted to pixels.
struct NearFont {
    std::size_t font = 0, shapes = 0;
    double em = 0, apart = 0;  // units; em, all together
    bool operator<(const NearFont& other) const { return shapes != other.shapes ? shapes > other.shapes : apart < other.apart; }
};

/// For each shape of the figure, its possible letters, which look the same. Empty: unknown.
using LettersOfShapes = std::vector<std::vector<FontLetter>>;

class ShapeSet {
public:
    /// `own` are the indices of its shapes in `outlines`.
    ShapeSet(const std::vector<OutlineMeasure>& outlines, std::vector<std::size_t> own);

    /// Looks for its shapes among the letters of the font with that number. True: this is the font.
    bool matches(const std::vector<FontLetter>& font, std::size_t number);
    /// The same, for an em of exactly that many units.
    bool matches_at(const std::vector<FontLetter>& font, double em);
    /// The font that matched, or the best near match.
    const std::vector<NearFont>& candidates() const { return candidates_; }
    /// Possible letters of a shape that is hinted to pixels.
    std::vector<char32_t> near(const std::vector<FontLetter>& font, double em) const;

    /// Assigns letters of the last matching font to shapes that have none yet.
    void take(const std::vector<FontLetter>& font, LettersOfShapes& read) const;
    /// Units of an em of the font that matched.
    double em() const { return em_; }
    /// Whether every shape has a letter.
    bool is_read(const LettersOfShapes& read) const;

private:
    std::vector<std::size_t> own_;
    std::vector<OutlineMeasure> outlines_;
    std::vector<NearFont> candidates_;
    double em_ = 0;
};

}  // namespace tactics
