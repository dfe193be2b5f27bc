// SPDX-License-Identifier: Apache-2.0
// Whether a picture has to be converted again (--update).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tactics/job/made_record.h"

namespace tactics {

/// Nothing: all outputs exist, and this version made them from this picture with these settings. Else the reasons to make them
/// anew, in words; no words if none exists.
/// `strict`: a page counts only if it is known to break no hard rule.
std::optional<std::vector<Phrase>> reasons_to_make(const MadeWith& settings, const Item& item, bool strict);
/// The same for pictures bound into files, whose records describe all of them, and for their other outputs.
std::optional<std::vector<Phrase>> reasons_to_bind(const MadeWith& settings, std::span<const Item> items, bool strict);

}  // namespace tactics
