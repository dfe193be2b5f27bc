// SPDX-License-Identifier: Apache-2.0
// Which languages write 0,5 and not 0.5.
#pragma once

#include <string_view>

namespace tactics {

/// Of a BCP 47 tag such as de, de-AT, es-MX or sr-Latn: whether numbers have a decimal comma there. False for what is not known.
bool writes_comma(std::string_view language);

}  // namespace tactics
