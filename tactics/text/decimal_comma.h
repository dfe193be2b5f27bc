// SPDX-License-Identifier: Apache-2.0
// Languages that write 0,5 instead of 0.5.
#pragma once

#include <string_view>

namespace tactics {

/// Whether numbers have a decimal comma, for a BCP 47 tag such as de, de-AT, es-MX or sr-Latn. False for unknown tags.
bool writes_comma(std::string_view language);

}  // namespace tactics
