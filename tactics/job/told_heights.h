// SPDX-License-Identifier: Apache-2.0
// What is said of the heights that the lines of a page have on a machine with several of them.
#pragma once

#include <optional>
#include <span>

#include "print/format.h"
#include "print/kind_heights.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Nothing: dots of the format have one height, or the user has said which they have.
std::optional<KindHeights> chosen_heights(const Format& format, const Settings& settings, std::span<const Page> pages);

/// For the user: how many are used, what for, and what fewer would lose.
Phrase explained(const KindHeights& heights, const Format& format);

}  // namespace tactics
