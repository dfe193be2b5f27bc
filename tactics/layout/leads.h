// SPDX-License-Identifier: Apache-2.0
// Lead lines: from words to what they name, past everything else.
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
    /// What a lead line of that width keeps `clear` mm from, edge to edge: the lines and areas that are on the page now.
    Leads(const Page& page, double width, double clear);

    /// Where a lead line to that place may end, best first: on the ink that is nearer to it than a line may pass, or that it lies
    /// in; else there.
    std::vector<Point> ends_for(Point thing) const;

    /// It keeps clear of all ink but that which it ends on. With `across` it may also cross lines. Where it meets ink it does so
    /// steeply enough to be felt as a line of its own (28 degrees, as the rule gap takes for a meeting).
    bool is_clear(const Lead& lead, bool across) const;

    /// It is on the page from now on.
    void add(const Lead& lead);

private:
    /// Some sides of a chain, one after another, so that those far away need not be looked at one by one.
    struct Block {
        std::size_t first = 0, end = 0;  ///< points that their sides lead to; the first point has a side to itself
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
    /// Where a lead line may end: so far from the thing, on that chain, so far along it.
    struct End {
        double apart = 0;  ///< mm from ink; to begin with, the most that is looked for
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
    std::size_t in_grid_ = 0;  // those that were on the page; lead lines come behind them
    Grid grid_;
    std::vector<InkedArea> areas_;  // for what lies in one
};

}  // namespace tactics
