// SPDX-License-Identifier: Apache-2.0
// Lead lines: from words to the thing that they name, clear of everything else.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/geometry/grid.h"
#include "tactics/page.h"

namespace tactics {

struct Lead {
    Point from, to;
};

class Leads {
public:
    /// The current lines and areas of the page, from which a lead line of that width keeps `clear` mm, edge to edge.
    Leads(const Page& page, double width, double clear);

    /// Possible ends of a lead line to that point, best first: on the ink that contains the point or is too near for a line to
    /// pass; else the point itself.
    std::vector<Point> ends_for(Point thing) const;

    /// The lead line keeps clear of all ink except where it ends, and of other lead lines. With `across` it may also cross lines,
    /// with `leads` lead lines, too. It meets ink at an angle steep enough to be felt as a separate line (28 degrees, the limit
    /// for a meeting in the rule gap).
    bool is_clear(const Lead& lead, bool across, bool leads = false) const;

    /// A line or an area is no farther than that.
    bool has_ink_near(Point place, double within) const;

    /// The number of places where it crosses a line, none where it ends; a crossing of another lead line counts four times, as a
    /// finger does not know which of them goes on.
    std::size_t crossings(const Lead& lead) const;

    /// Adds it to the ink on the page.
    void add(const Lead& lead);

private:
    /// Some consecutive sides of a chain, so that distant ones can be skipped together.
    struct Block {
        std::size_t first = 0, end = 0;  ///< points at which the sides end; the first point has a side to itself
        double along = 0;                ///< mm from the chain's beginning
        Box box;                         ///< of the middle line
    };
    struct Chain {
        std::vector<Point> points;
        bool closed = false;
        double half_width = 0;
        double length = 0;
        Box box;  ///< of its ink
        std::vector<Block> blocks;
    };
    /// A possible end of a lead line: distance from the thing, chain, and distance along the chain.
    struct End {
        double apart = 0;  ///< mm from ink; initially the largest distance of the search
        const Chain* chain = nullptr;
        double along = 0;
    };
    struct InkedArea {
        std::vector<std::vector<Point>> rings;
        Box box;
    };
    std::vector<std::size_t> chains_near(const Box& box) const;
    void look_for_end(std::size_t chain, Point thing, End& best) const;
    void add_chain(const std::vector<Point>& points, bool closed, double half_width);
    bool is_clear_of(const Chain& chain, const Lead& lead, bool across) const;

    double half_, clear_;
    std::vector<Chain> chains_;
    std::size_t in_grid_ = 0;         // number of chains that were on the page; lead lines follow them
    mutable std::size_t in_way_ = 0;  // the chain that the last line met, which the next one often meets, too
    Grid grid_;
    std::vector<InkedArea> areas_;  // for points inside an area
};

}  // namespace tactics
