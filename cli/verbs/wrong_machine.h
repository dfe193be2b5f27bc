// SPDX-License-Identifier: Apache-2.0
// Bytes that were written for another machine than they are to be sent to.
#pragma once

#include <string>
#include <string_view>

#include "print/format.h"

namespace tactics {

/// Throws Error(usage) at `name`, that of the file, if `format` would not understand something in the bytes and another embosser
/// understands all of them, with a set-up of its own: then they are clearly for that. `settings` are those of `format`. What both
/// understand is not told apart.
void refuse_wrong_machine(const std::string& name, std::string_view bytes, const Format& format, const Settings& settings);

}  // namespace tactics
