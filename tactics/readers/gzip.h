// SPDX-License-Identifier: Apache-2.0
// What is packed with gzip (RFC 1952) or in zlib's format (RFC 1950), unpacked within a limit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactics {

bool is_gzip(std::string_view bytes);

/// Unpacks at most the first `most` bytes; ask for one more than you can use to see whether there are more. Throws Error(failed)
/// at `name` if the data are truncated or damaged before that.
std::string gunzip(std::string_view bytes, std::size_t most, const std::string& name);

/// The first unpacked bytes, as far as `bytes`, the beginning of a file, determine them.
std::string gunzip_beginning(std::string_view bytes, std::size_t most);

/// The same as gunzip for zlib's format.
std::string inflated(std::string_view bytes, std::size_t most, const std::string& name);

}  // namespace tactics
