// SPDX-License-Identifier: Apache-2.0
// The pages that a drawing is printed on.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tactics/layout/place.h"
#include "tactics/page.h"

namespace tactics {

/// All that is printed of a drawing.
struct Pages {
    std::vector<Page> all;      ///< in the order in which they are printed; at least one
    std::size_t drawn = 0;      ///< the first that has the drawing on it
    std::optional<Page> large;  ///< before it was cut; nothing: it was not
    Place place = {};           ///< of the drawing on that

    /// With all of the drawing on it, in one piece: what is told of the drawing is told of this.
    const Page& whole() const { return large ? *large : all[drawn]; }
};

}  // namespace tactics
