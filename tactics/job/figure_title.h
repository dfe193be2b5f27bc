// SPDX-License-Identifier: Apache-2.0
// The title that a figure has at its top.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/print_words.h"

namespace tactics {

/// Words above all others are the page's title if no line is drawn above or beside them; in several lines, or too long for one
/// line of braille, they are it in any case, as only a title has room for that. They are marked, as no name stands for them then.
/// Empty: there is none. `places` are those of `told`, and the lines begin at `first_ink` from the top, in percent.
std::string take_title(std::vector<ToldWords>& told, const std::vector<PrintPlace>& places, double first_ink);

}  // namespace tactics
