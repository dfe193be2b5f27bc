// SPDX-License-Identifier: Apache-2.0
// Numbers as they stand in SVG: one after the other, with commas or without, and lengths with units.
#pragma once

#include <optional>
#include <string_view>

namespace tactics {

inline bool is_svg_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
std::string_view without_svg_blanks(std::string_view text);

/// Takes a number and the blanks and the comma after it from the front of `text`: "1.5.5-2e3" is three of them. Nothing, and
/// nothing is taken, if there is none.
std::optional<double> take_svg_number(std::string_view& text);

/// The flag of an arc: one letter, "01.5" begins with two of them.
std::optional<bool> take_svg_flag(std::string_view& text);

/// In px (1/96 in), a percentage being of `whole`: "12", "3mm", "50%".
std::optional<double> parse_svg_length(std::string_view text, double whole);

/// A font's size, which em and percent tell by that of the element around it; that one if the text is no size.
double parse_font_size(std::string_view text, double outer);

}  // namespace tactics
