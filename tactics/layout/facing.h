// SPDX-License-Identifier: Apache-2.0
// Pages for printing on both sides of the sheets.
#pragma once

#include <vector>

#include "tactics/layout/pages.h"

namespace tactics {

/// The sides of the sheets, front and back alternating, in the order of a bound book: fronts lie on the right, backs on the left.
/// `drawn` is the number of pages with the drawing.
///
/// The back of a drawing stays blank, because dots there would be felt through it (BANA, Braille Formats 2011, E.4.1). A key of
/// one page faces the drawing on its left (BANA, Guidelines and Standards for Tactile Graphics,
/// 2.20; the American Printing House asks for the same); with a longer key, the drawing lies on the left and the key on the
/// fronts after it (5.8.3). If the drawing has several sheets, a longer key comes first, and its last page faces the first sheet.
Pages on_both_sides(Pages drawn, std::vector<Page> key);

}  // namespace tactics
