// SPDX-License-Identifier: Apache-2.0
// The man page, made from all descriptions.
#pragma once

#include <string>

namespace tactics {

/// roff with the man macros; the same bytes from the same program (no date).
std::string manual();

}  // namespace tactics
