// SPDX-License-Identifier: Apache-2.0
// One error type for every fault that a user can correct: what is wrong, where, and how to correct it.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

/// The kind of fault; its value is the program's exit code.
enum class Fault {
    usage = 1,   ///< the command line or a recipe asks for something that does not exist
    failed = 2,  ///< the request was right but could not be carried out (bad file, full disk)
};

/// Message format: `PLACE: what is wrong (how to mend it)`, one line, no final period.
/// PLACE is where the user can find it: `lines.recipe:3`, `photo.jpg`, `--filter 2`; empty if there is none.
class Error : public std::runtime_error {
public:
    Error(Fault fault, const Phrase& place, Phrase message);
    Fault fault() const noexcept { return fault_; }
    /// The same as what(), in the language of whoever is to mend it.
    const Phrase& told() const noexcept { return *told_; }

private:
    Fault fault_;
    std::shared_ptr<const Phrase> told_;  // an exception is copied without a throw
};

/// The spelling of a wish in messages, for wishes such as "margin" and "real-width". Each program spells it as its users write
/// it: the command line as an option, "--margin".
std::string spelled(std::string_view wish);
/// Sets the prefix; the default is none. Call it at program start, before there are threads.
void spell_wishes_with(std::string prefix);

/// ` (WORD?)` for the nearest name by edit distance, or empty if none is near, to end "no filter X" messages.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& names);

}  // namespace tactics
