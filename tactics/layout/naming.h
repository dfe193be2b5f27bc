// SPDX-License-Identifier: Apache-2.0
// Places the names of things beside the things.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tactics/layout/key.h"
#include "tactics/layout/sheet.h"

namespace tactics {

/// A finger that has found the thing finds what is no farther than this without a line that leads there; twice the least gap. mm.
inline constexpr double kBesideThing = 6.4;

/// Sets each name in braille (in print if the sheet has no braille) on a page that has all its ink, clear of that ink: around its
/// thing or beside it; if there is no room, farther off with a lead line, or at another place of the border of its region;
/// failing that, as two letters beside the thing, the same for the same words, with the words in a key. Its region is one of the
/// same name; without one it stays at its place, and only if it must be there and has no room do its letters go to the border of
/// what lies there. Lead lines cross lines only where nothing else is left, and as few as possible. `names` are in page
/// millimetres. The lead lines become strokes. If there are windows (the parts of a large page that each sheet shows), every name
/// stands whole in one of them.
///
/// Returns the key if it has no room on the page, else nothing. Throws Error(usage) at the name's origin as to_braille does, and
/// if not even two letters have room.
std::vector<KeyEntry> set_names(Page& page, const std::vector<Name>& names, const Sheet& sheet,
                                std::span<const Rect> windows = {});

/// What the names of a page cost a hand: nothing beside the thing, more if they are led to it, have a key, or are left out.
struct NamesCost {
    double cost = 0;
    std::size_t left_out = 0;
};

/// What they cost when `set_names` sets them; nothing if that is `most` or more, which is often known after a few of them.
/// Throws as set_names does.
std::optional<NamesCost> cost_of_names(const Page& page, const std::vector<Name>& names, const Sheet& sheet,
                                       std::span<const Rect> windows, double most);

}  // namespace tactics
