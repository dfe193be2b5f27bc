// SPDX-License-Identifier: Apache-2.0
// Detects bytes that were written for another machine.
#pragma once

#include <string>
#include <string_view>

#include "print/format.h"

namespace tactics {

/// Throws Error(usage) at `name`, that of the file, if `format` would not understand something in the bytes and another embosser
/// understands all of them, with a set-up of its own: then they are clearly for that one. `settings` are those of `format`. Bytes
/// that both understand are accepted.
void refuse_wrong_machine(const std::string& name, std::string_view bytes, const Format& format, const Settings& settings);

}  // namespace tactics
