// SPDX-License-Identifier: Apache-2.0
// What a queue of CUPS and a print job wish. The job's words come from anyone who may print: they choose among what the queue's
// PPD file offers, and name no file.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "print/format.h"
#include "tactics/job/wishes.h"

namespace tactics {

/// The lines of a PPD file that are ours, or the queue's own defaults, in their order.
struct PpdWords {
    std::string embosser;
    std::vector<std::pair<std::string, std::string>> defaults;  ///< "TacticsRecipe", "photo"
    std::map<std::string, std::set<std::string>> choices;       ///< of each option, as named in the file
};

/// `*Key: value` and `*Option choice/words: code` lines; whatever else stands there is passed over.
PpdWords parse_ppd(std::string_view text);

/// NAME=VALUE of options as CUPS writes them, `a=b flag nofold c='d e'`, in their order; a name alone is true, with "no" before
/// it false.
std::vector<std::pair<std::string, std::string>> parse_cups_options(std::string_view text);

/// What the PPD file says of the machine, then what the print job asks for besides.
struct Queue {
    const Format* embosser = nullptr;
    Wishes wishes;
    std::vector<PlacedWords> labels = {};
};

/// `place` is the PPD file's, for messages; `name` the job's own, which is its title only if it wishes so. Throws Error: it names
/// no embosser; a recipe, a language or a braille table that the file does not offer or that did not come with the program and
/// with liblouis; a setting, a paper or a wish that there is not; labels that are none.
Queue queue_of(const PpdWords& ppd, const std::string& place, std::string_view options, const std::string& name = "");

}  // namespace tactics
