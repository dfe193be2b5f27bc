// SPDX-License-Identifier: Apache-2.0
// The server side of the programs that read untrusted files: an isolated child answers each request.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/readers/caged/protocol.h"
#include "tactics/transport/cage.h"

namespace tactics::caged {

// The descriptors of the file and of the answer, whatever they were in the program.
inline constexpr int kFile = 0, kAnswer = 1;
inline constexpr const char* kFilePath = "/dev/fd/0";

void put(Frame kind, const void* bytes, std::size_t size);
[[noreturn]] void fail(std::string text);  ///< ends the answer with a fault; empty: the data make no sense

/// Serves until there are no more requests: passes the lines of each, at least three (version, verb, format), to `answer` in a
/// forked child with the given limits. Does not return.
[[noreturn]] void serve_requests(void (*answer)(const std::vector<std::string>& lines),
                                 CageLimits (*limits_for)(const std::vector<std::string>& lines) = nullptr);

}  // namespace tactics::caged
