// SPDX-License-Identifier: Apache-2.0
// What commands ask alike about an embosser whose bytes they read.
#pragma once

#include "cli/command.h"
#include "print/format.h"

namespace tactics {

/// All of --set, as NAME.OPTION=VALUE of that embosser. Throws Error(usage).
Settings embosser_settings(const Format& format, const Given& given);

}  // namespace tactics
