// SPDX-License-Identifier: Apache-2.0
// One error type for everything that a user can mend: what is wrong, where, and how to mend it.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// What kind of fault, and the exit code that the program ends with because of it.
enum class Fault {
    usage = 1,   ///< the command line or a recipe asks for something that does not exist
    failed = 2,  ///< the request was right but could not be carried out (bad file, full disk)
};

/// Message format: `PLACE: what is wrong (how to mend it)`, one line, no final period.
/// PLACE is what the user can go to: `lines.recipe:3`, `photo.jpg`, `--filter 2`; empty if there is none.
class Error : public std::runtime_error {
public:
    Error(Fault fault, std::string_view place, std::string_view message);
    Fault fault() const noexcept { return fault_; }

private:
    Fault fault_;
};

/// How messages call a wish of whoever asks for a page: "margin", "real-width". A program spells it as its users write it: the
/// command line as an option, "--margin".
std::string spelled(std::string_view wish);
/// What is put before it; nothing if it is never called. For the program's beginning, before there are threads.
void spell_wishes_with(std::string prefix);

/// ` (WORD?)` for the nearest name by edit distance, or empty when none is near: for the end of "no filter X" messages.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& names);

}  // namespace tactics
