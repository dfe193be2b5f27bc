// SPDX-License-Identifier: Apache-2.0
// Files within a file.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tactics {

/// Of "data:image/png;base64,..." (RFC 2397) what follows the comma; nothing: it is not that.
std::optional<std::vector<unsigned char>> bytes_of_data_uri(std::string_view address);

}  // namespace tactics
