// SPDX-License-Identifier: Apache-2.0
// What is said of the heights that the lines of a page have on a machine with several of them.
#pragma once

#include <optional>

#include "print/format.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Those that the page has chosen; nothing: dots of the format have one height, or the user has said which they have.
std::optional<KindHeights> heights_to_tell(const Format& format, const Page& page);

/// For the user: how many are used, what for, and what fewer would lose.
Phrase explained(const KindHeights& heights, const Format& format);

}  // namespace tactics
