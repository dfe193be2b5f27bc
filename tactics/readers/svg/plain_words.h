// SPDX-License-Identifier: Apache-2.0
// Formulae in words of figures, as a line of plain signs that a braille table has cells for.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace tactics {

/// "-2" as "⁻²". Empty: it is no whole number.
std::string raised(std::string_view digits);

/// A word off the line of a formula, as it goes on there: "10" and "-3" up are 10\u207B\u00B3, "x" and "n+1" x^(n+1); figures
/// down stay as they are, as braille has them in most languages, and a ring up is a sign of degrees.
std::string off_line(const std::string& word, bool up);

/// What formulas raise for degrees.
inline constexpr std::array<std::string_view, 2> kRings{"\u25E6", "\u2218"};
inline constexpr std::string_view kDegree = "\u00B0";

/// The TeX in Matplotlib's words: "$CO_2$ in mg/m$^{3}$" as "CO2 in mg/m³", "$e^{-x}$" as "e^(−x)". What is not known here stays
/// as it is, all of it.
std::string without_markup(std::string_view text);

}  // namespace tactics
