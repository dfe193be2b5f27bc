// SPDX-License-Identifier: Apache-2.0
// Names of things beside the things.
#pragma once

#include <span>
#include <vector>

#include "tactics/layout/key.h"
#include "tactics/layout/sheet.h"

namespace tactics {

/// Sets each name in braille (in print if the sheet has no braille) on a page that has all its ink, clear of it: around its
/// thing or beside it; where there is no room, farther off with a lead line; where there is none for that, two letters beside
/// the thing and the words in a key. `names` are in page millimetres. The lead lines become strokes. Words stand in one of the
/// windows as a whole, if there are any: what each sheet of a large page shows.
///
/// Gives the key if that has no room there, else nothing. Throws Error(usage) at the name's origin as to_braille does, and if
/// not even two letters have room.
std::vector<KeyEntry> set_names(Page& page, std::vector<Name> names, const Sheet& sheet, std::span<const Rect> windows = {});

}  // namespace tactics
