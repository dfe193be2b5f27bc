// SPDX-License-Identifier: Apache-2.0
// An evaluation as a table to read, as a table for a spreadsheet, and in JSON.
#pragma once

#include <string>
#include <vector>

#include "tactics/measure/evaluation.h"

namespace tactics {

/// A line for each recipe, one for people and one for the simplest person, under a line of headings.
std::string evaluation_table(const Evaluation& evaluation);
/// The same rows with commas (RFC 4180).
std::string evaluation_csv(const Evaluation& evaluation);
/// One object a line: each recipe with its pictures, people, and last what the whole was.
std::string evaluation_json(const Evaluation& evaluation);

/// "sobel draws nothing on 3 pictures: a, b, c", one line for each recipe that does.
std::vector<std::string> nothing_lines(const Evaluation& evaluation);

}  // namespace tactics
