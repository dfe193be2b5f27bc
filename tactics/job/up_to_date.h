// SPDX-License-Identifier: Apache-2.0
// Whether a picture has to be converted again (--update).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tactics/job/made_record.h"

namespace tactics {

/// Nothing: all outputs are there, and were made of this picture with these settings by this version. Else why they are made
/// anew, in words; no words if none of them is there.
std::optional<std::vector<Phrase>> reasons_to_make(const MadeWith& settings, const Item& item);
/// The same of pictures that are bound into files, whose record tells of all of them, and of their other outputs.
std::optional<std::vector<Phrase>> reasons_to_bind(const MadeWith& settings, std::span<const Item> items);

}  // namespace tactics
