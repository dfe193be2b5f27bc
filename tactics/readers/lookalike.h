// SPDX-License-Identifier: Apache-2.0
// What a file that is not a picture looks like, and what could be done to get a picture of it.
#pragma once

#include <span>
#include <string>

namespace tactics {

/// How much of the file is looked at.
inline constexpr std::size_t kLookBytes = 4096;

/// The end of a sentence that starts with the file's name: "looks like a PDF document, not a picture; ...".
/// `head` is the first kLookBytes of the file, or all of it.
std::string lookalike(std::span<const unsigned char> head);

}  // namespace tactics
