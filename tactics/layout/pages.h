// SPDX-License-Identifier: Apache-2.0
// The pages that a drawing is printed on.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tactics/layout/place.h"
#include "tactics/page.h"

namespace tactics {

/// All pages to print for a drawing.
struct Pages {
    std::vector<Page> all;      ///< in printing order; at least one
    std::size_t drawn = 0;      ///< index of the first page with the drawing
    std::optional<Page> large;  ///< the page before it was cut into sheets; nothing: it was not cut
    Place place = {};           ///< of the drawing on that page

    /// The page with the whole drawing in one piece; descriptions of the drawing refer to it.
    const Page& whole() const { return large ? *large : all[drawn]; }
};

}  // namespace tactics
