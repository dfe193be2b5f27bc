// SPDX-License-Identifier: Apache-2.0
// Which letters a reading means, where several look the same.
#pragma once

#include <string>
#include <string_view>

#include "tactics/lettering/form_line.h"

namespace tactics {

/// Latin and Greek ones.
bool is_lower(char32_t code);
bool is_upper(char32_t code);

/// Spaces, dashes and what is small do not matter.
bool same_letters(std::string_view a, std::string_view b);

/// The other reader knows neither Greek letters nor signs of formulas: it says "P(cos 6, sin @)". Within a number are none.
bool same_but_for_signs(std::string_view a, std::string_view other);

/// Puts in the letters that are meant, by those beside them and by the other reading, and says whether it is clear which they
/// are.
void settle(FormWords& words, const OtherReading& other);

/// That text with the letters of the reading, where it has as many; its minus signs and what it has raised stay.
std::string with_letters(const std::string& text, const FormReading& reading);

}  // namespace tactics
