// SPDX-License-Identifier: Apache-2.0
// A matching study as text, as a table for a spreadsheet, and in JSON.
#pragma once

#include <string>
#include <string_view>

#include "studies/matching.h"

namespace tactics {

/// A line for each recipe under a line of headings; then sentences: the pictures and mistakes, whether the paper's order
/// comes out, and under how many random readers.
std::string matching_text(const MatchingStudy& study, std::string_view language);
/// A line for each recipe and, under it, one for each picture.
std::string matching_csv(const MatchingStudy& study);
/// One object per line: each recipe with its pictures and mistakes, and finally the whole study.
std::string matching_json(const MatchingStudy& study);

}  // namespace tactics
