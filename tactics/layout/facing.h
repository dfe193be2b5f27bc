// SPDX-License-Identifier: Apache-2.0
// Pages that are printed on both sides of their sheets.
#pragma once

#include <vector>

#include "tactics/layout/pages.h"

namespace tactics {

/// The sides of sheets, front and back by turns, in the order in which a bound book has them: fronts lie to the right, backs
/// to the left. `drawn` are the pages of a drawing alone.
///
/// Nothing stands on the back of a drawing, whose dots would be felt through it (BANA, Braille Formats 2011, E.4.1), so that
/// it is left blank. A key of one page faces the drawing on its left (BANA, Guidelines and Standards for Tactile Graphics,
/// 2.20; the American Printing House asks for the same); for a longer one the drawing lies to the left and the key on the
/// fronts behind it (5.8.3). Of a drawing of several sheets a longer key comes first, its last page facing the first sheet.
Pages on_both_sides(Pages drawn, std::vector<Page> key);

}  // namespace tactics
