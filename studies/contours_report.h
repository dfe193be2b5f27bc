// SPDX-License-Identifier: Apache-2.0
// An evaluation as a table to read, as a table for a spreadsheet, and in JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/measure/evaluation.h"

namespace tactics {

/// A line for each recipe, one for people and one for the simplest person, under a line of headings.
std::string evaluation_table(const Evaluation& evaluation, std::string_view language);
/// The same rows in English with commas (RFC 4180).
std::string evaluation_csv(const Evaluation& evaluation);
/// One object a line: each recipe with its pictures, people, and last what the whole was.
std::string evaluation_json(const Evaluation& evaluation);

/// "sobel draws nothing on 3 pictures: a, b, c", one line for each recipe that does.
std::vector<Phrase> nothing_lines(const Evaluation& evaluation);

}  // namespace tactics
