// SPDX-License-Identifier: Apache-2.0
// Files packed with gzip (RFC 1952), unpacked within a limit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactics {

bool is_gzip(std::string_view bytes);

/// No more than the first `most` bytes of what is packed: who asks for one more than it can use sees that there is more. Throws
/// Error(failed) at `name` if it is cut short or damaged before that.
std::string gunzip(std::string_view bytes, std::size_t most, const std::string& name);

/// The first bytes of what is packed, as far as `bytes`, the beginning of a file, tell.
std::string gunzip_beginning(std::string_view bytes, std::size_t most);

}  // namespace tactics
