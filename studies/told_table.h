// SPDX-License-Identifier: Apache-2.0
// A table of a study, in the reader's language or for a spreadsheet.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

using ToldRow = std::vector<Phrase>;

/// Aligned columns under a row of headings. Numbers have the decimal comma of the language, except in the first column, which has
/// names.
std::string told_table(const std::vector<ToldRow>& rows, std::string_view language);
/// The same in English, with commas (RFC 4180).
std::string told_csv(const std::vector<ToldRow>& rows);

/// "0.640" with the decimal comma of who reads it.
Phrase fixed_numeral(double value, int digits);

}  // namespace tactics
