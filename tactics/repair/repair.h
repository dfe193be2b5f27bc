// SPDX-License-Identifier: Apache-2.0
// A drawing made fit to be felt: what would break a hard rule is joined, moved, broken or left out, the least change first.
//
// Order of the means: of far too much line the strongest stays; heads of arrows go back from what they nearly touch; an end
// that nearly meets a line is led onto it; lines too close to each other are moved apart, by no more than a fingertip can tell,
// and small areas before them; areas too close or too black become outlines; at a crossing the lesser line is broken; of what is
// still too close the lesser part goes; dashed lines are cut into dashes. Lesser is: a line beside an area, a thinner line, less
// evidence (evidence.h).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/medium.h"

namespace tactics {

/// One thing that was done to the drawing.
struct Mend {
    enum class Kind {
        joined,     ///< an end was led onto the line that it nearly met
        moved,      ///< `mm`: how far at most
        shifted,    ///< a small area, as it is; `mm`: how far
        shrunk,     ///< a small area, so that a gap is beside it; `mm`: by how much
        enlarged,   ///< a small area, so that a finger finds it; `mm`: by how much
        outlined,   ///< an area is drawn as its outline
        broken,     ///< a gap was left in a line, at a crossing or where another comes near; `mm`: how much of it went
        shortened,  ///< the end of a line went
        merged,     ///< a line ran along another and both are one now; `mm`: for how long
        left_out,   ///< a whole line or area; `mm`: its length
        crowded,    ///< a point symbol is left out, as others are too close; `mm`: the length of its outline
    };
    Kind kind = Kind::moved;
    Point at;  ///< in the drawing
    double mm = 0;
};

struct Repaired {
    Drawing drawing;
    std::vector<Mend> changes;      ///< from top to bottom
    std::size_t broken_before = 0;  ///< places that broke a hard rule (of the rules about lines and areas)
    std::size_t broken_after = 0;   ///< 0 but for what cannot be mended
    double kept = 1;                ///< share of the length of lines and outlines that is still there
    /// False: the drawing has too much line to examine all of it.
    bool complete = true;
};

/// Takes the drawing in its size on the page. Pixel pictures, labels and names are unchanged. If there is more line than there is
/// room for, only the strongest is examined. Pure; a drawing with nothing to mend is returned unchanged. Time and memory are
/// bounded.
Repaired repair(Drawing drawing, const Medium& medium);

/// Dashed lines (Role::dash), whole till now, get dashes and gaps that a finger can follow; of very many the last stay whole.
/// False: none was cut. `repair` does that last of all.
bool cut_dashes(Drawing& drawing, const Medium& medium);

/// A drawing that loses more than this is reported as not fit to be felt at this size: with less than two thirds of its contents
/// it is no longer the same drawing. This project's own number.
inline constexpr double kLegible = 2.0 / 3;

/// Notes for a transcriber, one sentence each: "2 lines were moved by up to 0.8 mm." Nothing without changes.
std::vector<Phrase> notes_of(const Repaired& repaired);

}  // namespace tactics
