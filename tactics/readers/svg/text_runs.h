// SPDX-License-Identifier: Apache-2.0
// Words that a file has in pieces, joined.
#pragma once

#include <vector>

#include "tactics/readers/svg/found_page.h"

namespace tactics {

/// TeX sets each font by itself: "R" and its index are two texts, and so may be the figures of "10". What begins where another
/// text ends goes on with it; what is smaller and off its line is an index or an exponent. Words whose `run` is not known stay.
void join_text_runs(std::vector<FoundWords>& words);

}  // namespace tactics
