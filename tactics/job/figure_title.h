// SPDX-License-Identifier: Apache-2.0
// The title at the top of a figure.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/print_words.h"

namespace tactics {

/// The topmost words are the page's title if no line is drawn above or beside them. Words in several lines, or too long for one
/// braille line, are the title in any case, since only a title has room for them. They are marked, because no name represents
/// them then. Empty: there is no title. `places` are those of `told`; the lines begin at `first_ink` from the top, in percent.
std::string take_title(std::vector<ToldWords>& told, const std::vector<PrintPlace>& places, double first_ink);

}  // namespace tactics
