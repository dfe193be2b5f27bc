// SPDX-License-Identifier: Apache-2.0
// Formulae in words of figures, as a line of plain signs that a braille table has cells for.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

/// "-2" as "⁻²". Empty: it is no whole number.
std::string raised(std::string_view digits);

/// The TeX in Matplotlib's words: "$CO_2$ in mg/m$^{3}$" as "CO2 in mg/m³", "$e^{-x}$" as "e^(−x)". What is not known here stays
/// as it is, all of it.
std::string without_markup(std::string_view text);

}  // namespace tactics
