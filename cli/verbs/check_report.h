// SPDX-License-Identifier: Apache-2.0
// The findings of `check`, in words for a person and in three formats for programs.
#pragma once

#include <string>
#include <vector>

#include "tactics/medium.h"
#include "tactics/readers/svg/svg.h"
#include "tactics/rules/rule.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct Checked {
    std::string file;  ///< as the user named it
    FoundPage found;
    const Medium* medium = nullptr;
    std::vector<Verdict> verdicts;
    std::string error;  ///< empty: it was checked
};

struct Count {
    std::size_t hard = 0;
    std::size_t others = 0;
    bool complete = true;
};
Count count_of(const Checked& checked);

/// "34.2 mm right, 80.1 mm down" from the top left corner, or "whole page".
Phrase place_of(const Finding& finding);
/// "a gap of 1.2 mm between two lines, where at least 3.2 mm is asked for; move them apart or join them"
Phrase what_is_wrong(const Verdict& verdict, const Finding& finding);

/// One line per finding, at most `most` for each rule (the rest are counted), notes and a summary line. With `marks`, each
/// reported finding has the number that mark_page gives it. In the language of the user.
std::string text_report(const Checked& checked, std::size_t most, bool marks);
/// Everything in one object on one line.
std::string json_report(const Checked& checked);
/// SARIF 2.1.0 (OASIS): one file for all.
std::string sarif_report(const std::vector<Checked>& all);
/// JUnit: a suite for each page, a case for each rule, a failure where a hard rule is broken.
std::string junit_report(const std::vector<Checked>& all);

}  // namespace tactics
