// SPDX-License-Identifier: Apache-2.0
// Decides between two readings of a line, one by words and one by the letters of fonts.
#pragma once

#include <string>
#include <string_view>

#include "tactics/lettering/form_line.h"

namespace tactics {

/// The reading of a line by words.
struct ReadWords {
    std::string text;
    double sureness = 0;  ///< 0 to 100
    bool alike = false;   ///< read the same at two sizes, with as many words as there are gaps
    bool sure = false;    ///< sure enough to be believed where fonts have nothing to say
};

struct Belief {
    std::string text;
    double sureness = 0;
    bool sure = false;  ///< it may stand in braille
    bool tell = false;  ///< or a person should look at it
    /// It is not sure only since its print is so small that one reader does not do: numbers of an axis may bear it out.
    bool nearly = false;
    /// It is not sure only since one of its brackets has no partner, which may stand in what goes on after a gap.
    bool open = false;
};

/// Each closing bracket was opened, and each opened one is closed, but for "a)" as lists have it.
bool has_pairs(std::string_view text);

Belief believe(const FormWords& words, const ReadWords& other);

/// A unit that may stand alone: degrees of a scale of temperatures.
bool is_degrees(std::string_view text);

/// "5.O", "1l" and "l00": what else is in a number is a figure; and of "10 \u03a9" readers make "10 Q".
bool has_letter_for_figure(std::string_view text);
/// "MilI": a capital I that ends a word of small letters is an l.
bool ends_word_with_capital_i(std::string_view text);
/// "a = 30" may be an alpha, where no font tells.
bool names_letter_in_formula(std::string_view text);
/// "+ 1" and "= 5 cm" go on with something before them.
bool begins_in_formula(std::string_view text);

}  // namespace tactics
