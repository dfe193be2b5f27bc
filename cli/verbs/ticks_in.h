// SPDX-License-Identifier: Apache-2.0
// A recording of what was felt, in whichever of its two forms.
#pragma once

#include <optional>

#include "tactics/haptics/loop/tick_table.h"

namespace tactics {

/// A packed recording, or a table of ticks as play --csv writes it; nothing: the file is neither. Throws Error(failed): damaged.
std::optional<TickTable> ticks_in(Source& source);

}  // namespace tactics
