// SPDX-License-Identifier: Apache-2.0
// Options about an embosser, shared by the commands that read its bytes.
#pragma once

#include <cstdint>

#include "cli/command.h"
#include "print/format.h"
#include "tactics/medium.h"

namespace tactics {

enum class MachineKinds : std::uint8_t { embossers, with_displays };

/// --embosser, else the kept machine; nullptr: neither. If the user named a model, a note names its driver. Throws Error(usage).
const Format* machine_of(const Given& given, MachineKinds kinds);

/// The sheet in it: --paper, else the kept paper if the machine takes it, else its own; `format` may be nullptr.
Paper sheet_in(const Given& given, const Format* format, const Settings& settings);

/// The settings of the model that was named for machine_of, then those of --set, NAME.OPTION=VALUE of that embosser. Throws
/// Error(usage).
Settings embosser_settings(const Format& format, const Given& given);

}  // namespace tactics
