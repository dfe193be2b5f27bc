// SPDX-License-Identifier: Apache-2.0
// What commands ask alike about an embosser whose bytes they read.
#pragma once

#include <cstdint>

#include "cli/command.h"
#include "print/format.h"
#include "tactics/medium.h"

namespace tactics {

enum class MachineKinds : std::uint8_t { embossers, with_displays };

/// --embosser, else the machine that is kept; nullptr: neither. A typed name that is a model's is told. Throws Error(usage).
const Format* machine_of(const Given& given, MachineKinds kinds);

/// The sheet in it: --paper, else the kept one if the machine takes it, else its own; `format` may be nullptr.
Paper sheet_in(const Given& given, const Format* format, const Settings& settings);

/// What the model that machine_of was named by is set to, then all of --set, as NAME.OPTION=VALUE of that embosser. Throws
/// Error(usage).
Settings embosser_settings(const Format& format, const Given& given);

}  // namespace tactics
