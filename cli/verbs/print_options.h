// SPDX-License-Identifier: Apache-2.0
// The options of a CUPS queue and a print job. Anyone who may print can set the job's options, so they only choose among those in
// the queue's PPD file, and name no file.
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

/// "TacticsRecipe", "photo"; what is said last counts.
using PrintOptions = std::vector<std::pair<std::string, std::string>>;

/// Our own lines in a PPD file, or the queue's defaults, in order.
struct PpdWords {
    std::string embosser;
    PrintOptions defaults;
    std::map<std::string, std::set<std::string>> choices;  ///< of each option, as named in the file
};

/// Parses `*Key: value` and `*Option choice/words: code` lines; ignores everything else.
PpdWords parse_ppd(std::string_view text);

/// NAME=VALUE pairs from options as CUPS writes them, `a=b flag nofold c='d e'`, in order; a name alone means true, with "no"
/// before it false.
PrintOptions parse_cups_options(std::string_view text);

/// The wishes from the PPD file, then those of the print job.
struct Queue {
    const Format* embosser = nullptr;
    Wishes wishes;
    std::vector<PlacedWords> labels = {};
};

/// `place` is the PPD file, for messages; `name` is the job's name, which becomes its title only on request. Throws Error if the
/// file names no embosser, for a recipe, a language or a braille table that the file does not offer or that did not come with the
/// program or liblouis, for an unknown setting, paper or wish, and for invalid labels.
Queue queue_of(const PpdWords& ppd, const std::string& place, const PrintOptions& options, const std::string& name = "");

}  // namespace tactics
