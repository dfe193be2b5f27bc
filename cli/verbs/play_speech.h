// SPDX-License-Identifier: Apache-2.0
// --speak for a play on an arm.
#pragma once

#include <optional>

#include "cli/command.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/voice/speaking.h"
#include "tactics/plot.h"

namespace tactics {

/// Nothing without --speak. Throws Error(usage).
std::optional<Speaking> speaking_of(const Given& given, const Plot& plot, const PlotFrame& frame, bool quiet);

/// Waits for the voice to end. Missing or broken speech gives a note, never a failure.
void tell_voice(Speaking& speaking, bool quiet);

}  // namespace tactics
