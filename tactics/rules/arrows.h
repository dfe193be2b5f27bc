// SPDX-License-Identifier: Apache-2.0
// Heads of arrows as they stand on a page.
#pragma once

#include <optional>
#include <vector>

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

/// What heads point to.
class ArrowTargets {
public:
    /// The geometry must outlive it.
    explicit ArrowTargets(const PageGeometry& geometry);

    struct Target {
        double gap = 0;  ///< mm from ink to ink; less than 0: they overlap
        Point at;        ///< on its middle line
    };
    /// The nearest thing before the head, within `reach` mm, neither that nor its shaft; as if its tip were at `tip`.
    std::optional<Target> before(const ArrowHead& head, Point tip, double reach);
    /// The shaft ends at the tip or between the barbs; it comes from behind.
    bool is_shaft(const ArrowHead& head, std::uint32_t chain) const;
    /// False: there is too much on the page to look at all of it.
    bool complete() const { return budget_ > 0; }

private:
    const PageGeometry& geometry_;
    Grid grid_;
    std::size_t budget_ = 100'000'000;
};

/// The page's chains with the role; of an area, only its first ring.
std::vector<std::uint32_t> chains_with(const PageGeometry& geometry, Role role);

}  // namespace tactics
