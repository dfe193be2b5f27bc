// SPDX-License-Identifier: Apache-2.0
// What commands ask alike about an embosser whose bytes they read.
#pragma once

#include "cli/command.h"
#include "print/format.h"

namespace tactics {

/// All of --set, as NAME.OPTION=VALUE of that embosser. Throws Error(usage).
Settings embosser_settings(const Format& format, const Given& given);

/// Puts a file behind what is there; "-" is standard input. A pipe can be read once only. Throws Error: not there, over 256 MB
/// together.
void append_file(std::string& bytes, const std::string& name);

}  // namespace tactics
