// SPDX-License-Identifier: Apache-2.0
// What lies behind an opaque surface of a figure is not seen, and not drawn; words there are told of.
#pragma once

#include <vector>

#include "tactics/readers/svg/found_page.h"
#include "tactics/readers/svg/svg_path.h"
#include "tactics/readers/svg/svg_style.h"

namespace tactics {

/// The next surface of a figure, before it is drawn: kept if it lets nothing through and is no mark on a line. `clip`: what is to
/// be seen of all, mm.
void add_cover(FoundPage& figure, const std::vector<Subpath>& surface, const Paint& fill, const Rect& clip);

/// Cuts away what was drawn before the surfaces that were kept and lies behind them. One whose outline is not, or no longer,
/// there hides nothing: it makes room for words, or was a legend. Of very many lines and surfaces some stay.
void hide_behind_covers(FoundPage& figure);

}  // namespace tactics
