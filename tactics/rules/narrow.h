// Where two things come too near to each other with white between them.
#pragma once

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

/// What `apart` counts: from edge to edge, or between middle lines.
enum class Apart { edges, middles };

/// The narrowest place between each two lines or areas (or between two parts of one) that are nearer than `limit` and do
/// not touch there. A texture's distance from lines is the rule texture-clearance's; here it counts between middles only, and
/// its own marks never. No gap is
/// - a bend, a corner or a meeting: where the way from one place to the other through ink is at most four times the
///   distance between their middle lines (lines that meet at 29 degrees or more);
/// - what is black between the two, or has a third thing in it.
Findings narrow_places(const PageGeometry& geometry, double limit, Apart apart);

/// Two pieces that are nearer than the limit, where they are nearest.
struct NarrowPair {
    std::uint32_t one = 0, other = 0;  ///< pieces
    double measured = 0;
    Point at, other_at;  ///< on their middle lines
};
/// All that make the narrow places, not just the narrowest between each two things.
struct NarrowPairs {
    std::vector<NarrowPair> pairs;
    bool complete = true;
};
NarrowPairs narrow_pairs(const PageGeometry& geometry, double limit, Apart apart);

/// "two lines", "a line and an area", "two parts of a line"
std::string pair_words(const Chain& one, const Chain& other, bool same);

}  // namespace tactics
