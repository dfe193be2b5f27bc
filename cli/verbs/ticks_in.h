// SPDX-License-Identifier: Apache-2.0
// A recording of a play, in either of its two forms.
#pragma once

#include <optional>

#include "tactics/haptics/loop/tick_table.h"

namespace tactics {

/// A packed recording, or a table of ticks as play --csv writes it; nothing: the file is neither. Throws Error(failed) if it is
/// damaged.
std::optional<TickTable> ticks_in(Source& source);

}  // namespace tactics
