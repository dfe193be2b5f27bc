// SPDX-License-Identifier: Apache-2.0
// Guesses the kind of a file that is no picture, and how to get a picture from it.
#pragma once

#include <span>

#include "tactics/text/phrase.h"

namespace tactics {

/// How much of the file is examined.
inline constexpr std::size_t kLookBytes = 4096;

/// The end of a sentence that starts with the file's name: "looks like a PDF document, not a picture; ...".
/// `head` is the first kLookBytes of the file, or all of it.
Phrase lookalike(std::span<const unsigned char> head);

}  // namespace tactics
