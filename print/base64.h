// SPDX-License-Identifier: Apache-2.0
// Bytes within text, for pictures in XML.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

/// RFC 4648, section 4: without line breaks.
std::string to_base64(std::string_view bytes);

}  // namespace tactics
