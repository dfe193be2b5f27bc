// SPDX-License-Identifier: Apache-2.0
// A line of lettering read by holding the letters of a font against it.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/lettering/form_font.h"
#include "tactics/lettering/ink_letters.h"

namespace tactics {

/// Pixels for an em: in smaller print an l is hardly higher than an I, and the dot of an i may be pale. A setting.
inline constexpr double kSmallPrint = 16;

/// Two letters that touch in small print and look like one: rn and m, cl and d.
inline constexpr std::u32string_view kLikeOne[] = {U"rn", U"cl", U"ri", U"li", U"Cl", U"vv", U"Fi", U"fi"};

inline constexpr char32_t kMinus = 0x2212, kEnDash = 0x2013;
/// What may stand before a figure; not every dash (utf8.h).
constexpr bool is_minus(char32_t code) { return code == '-' || code == kMinus || code == kEnDash; }

/// The reading of a piece of ink.
struct FormLetter {
    enum class Place { on_line, raised, lowered };
    char32_t code = 0;  ///< 0: like no letter of the font
    double likeness = 0;
    double margin = 1;     ///< by so much it is more likely than what is not alike and could stand there
    bool slanted = false;  ///< as formulas have it
    bool touches = false;  ///< its ink is that of letters which touch, and is as high as all of them
    bool pair = false;     ///< in small print it may be two letters that touch: "rn" for m
    Place place = Place::on_line;
    std::vector<char32_t> alike;  ///< others that it may be as well, by its looks, its size and where it stands
    InkBox box;

    bool may_be(char32_t other) const { return code == other || std::find(alike.begin(), alike.end(), other) != alike.end(); }
};

struct FormReading {
    std::vector<FormLetter> letters;
    std::string text;     ///< as text_of says it; empty: some piece is like no letter
    double em = 0;        ///< pixels
    double foot = 0;      ///< where the line is that letters stand on, pixels of the strip
    double value = 0;     ///< pixels of width, weighed by likeness: the more the better
    double least = 0;     ///< likeness of the least likely letter
    double margin = 1;    ///< of the letter with the smallest one
    double mean = 0;      ///< of all, by their width
    bool pair = false;    ///< of any letter
    bool either = false;  ///< another size of letters, with other letters, would do as well: "cos" or "COS"
};

/// `known` are the sizes, in pixels for an em, of other lines of the picture in this font: of two sizes that would do it is one
/// of them. `guess` is what the line may say: where letters touch, those that stand side by side in it are looked for as one;
/// `only_guessed` looks for no letters but those of it.
FormReading read_by_forms(const InkStrip& strip, FormFont& font, const std::vector<double>& known, std::string_view guess = {},
                          bool only_guessed = false);

/// The text of its letters, with spaces where the font leaves room for one, and with superscripts and subscripts.
std::string text_of(const FormReading& reading, FormFont& font);

/// It has spaces, and none is as wide as those between words.
bool has_thin_spaces(const FormReading& reading, FormFont& font);

/// The similarity of the line to those letters in that font, 0 to 1; 0 if the letters differ. `em` receives their size.
double likeness_to(const InkStrip& strip, FormFont& font, std::string_view text, double& em);

}  // namespace tactics
