// SPDX-License-Identifier: Apache-2.0
// Text within XML.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

/// Escapes text for content and for attributes in double quotes.
std::string escaped(std::string_view text);

}  // namespace tactics
