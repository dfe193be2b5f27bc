// SPDX-License-Identifier: Apache-2.0
// The places of a drawing's words if a machine sets them in cells, computed before layout.
#pragma once

#include "tactics/layout/label.h"
#include "tactics/layout/place.h"

namespace tactics {

class CellPlaces {
public:
    /// For a drawing whose top left corner is at `origin` on the page.
    CellPlaces(const Sheet& sheet, const Place& place, Point origin);

    bool anywhere() const { return !(across_ > 0); }
    double cell_pitch() const { return across_; }  ///< mm from one place to the next; 0: anywhere
    double line_pitch() const { return down_; }    ///< mm; only where words cannot stand anywhere
    /// The top left corner of a block, moved so that its braille is where it will be set: to the nearest place, or to the next
    /// one on the right and below.
    Point nearest(Point at, const LabelBlock& block) const;
    Point next(Point at, const LabelBlock& block) const;

    /// The next possible place of a cell's first dot at or after `at`; `at` itself if any place is possible.
    Point next_cell(Point at) const;

private:
    Point first_;  ///< of a cell's first dot, in the drawing
    double across_ = 0, down_ = 0;
};

}  // namespace tactics
