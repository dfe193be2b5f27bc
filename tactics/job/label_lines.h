// SPDX-License-Identifier: Apache-2.0
// Lines of print that make one label, as makers of diagrams set it: one below the other, each in the middle.
#pragma once

#include <functional>
#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/job/told_words.h"

namespace tactics {

/// A line of print where it stands, in any unit that is the same across and down.
struct PlacedLine {
    Box box;
    double letters = 0;    ///< height of its capitals
    bool upwards = false;  ///< it runs from the bottom to the top
    bool centred = false;  ///< it is known to be set by its middle; else its sides tell
};

/// What is drawn where lines of print stand.
struct DrawnAround {
    std::function<bool(const Box& place)> is_free;             ///< nothing is drawn there
    std::function<bool(Point one, Point other)> is_one_thing;  ///< the same closed line is the next around both
};

/// Joins those of `told`, whose places are `lines`, that are set where they are and make one label: of one size, line below line,
/// their middles one below the other, with nothing drawn between them. Numbers of an axis and names of its categories make none
/// with what stands below them. The first of them has the words then, at the middle of all, and the others are taken out of
/// `told`.
void join_label_lines(std::vector<ToldWords>& told, const std::vector<PlacedLine>& lines, const DrawnAround& drawn);

}  // namespace tactics
