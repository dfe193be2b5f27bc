// SPDX-License-Identifier: Apache-2.0
// Whether a picture has to be converted again (--update).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/job/made_record.h"

namespace tactics {

/// Nothing: all outputs are there, and were made of this picture with these settings by this version. Else why they are made
/// anew, in words; no words if none of them is there.
std::optional<std::vector<std::string>> reasons_to_make(const MadeWith& settings, const Item& item);

}  // namespace tactics
