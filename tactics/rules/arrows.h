// SPDX-License-Identifier: Apache-2.0
// Heads of arrows as they stand on a page.
#pragma once

#include <optional>

#include "tactics/rules/page_geometry.h"

namespace tactics {

/// An open head: from the end of one barb over the tip to the end of the other.
struct ArrowHead {
    std::uint32_t chain = 0;
    Point tip;
    Point forward;  ///< of length 1
};

/// Nothing for what is closed, filled or straight.
std::optional<ArrowHead> arrow_head(const PageGeometry& geometry, std::uint32_t chain);

/// The page's chains with the role; of an area, only its first ring.
std::vector<std::uint32_t> chains_with(const PageGeometry& geometry, Role role);

}  // namespace tactics
