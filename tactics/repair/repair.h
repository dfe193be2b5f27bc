// SPDX-License-Identifier: Apache-2.0
// A drawing made fit to be felt: what would break a hard rule is joined, moved, broken or left out, the least change first.
//
// Order of the means: of far too much line the strongest stays; an end that nearly meets a line is led onto it; lines too close
// to each other are moved apart, by no more than a fingertip can tell; areas too close or too black become outlines; at a
// crossing the lesser line is broken; of what is still too close the lesser part goes; dashed lines are cut into dashes. Lesser
// is: a line beside an area, a thinner line, less evidence (evidence.h).
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
        outlined,   ///< an area is drawn as its outline
        broken,     ///< a gap was left in a line, at a crossing or where another comes near; `mm`: how much of it went
        shortened,  ///< the end of a line went
        merged,     ///< a line ran along another and both are one now; `mm`: for how long
        left_out,   ///< a whole line or area; `mm`: its length
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
    /// False: there is so much in the drawing that not all of it could be looked at.
    bool complete = true;
};

/// The drawing in the size in which it will stand on the page. A picture of pixels is left as it is, as are labels and names.
/// Of more line than there is room for only the strongest is looked at. Pure; without anything to mend the drawing comes back
/// untouched. Time and memory are bounded.
Repaired repair(Drawing drawing, const Medium& medium);

/// Dashed lines (Role::dash), whole till now, get dashes and gaps that a finger can follow; of very many the last stay whole.
/// False: none was cut. `repair` does that last of all.
bool cut_dashes(Drawing& drawing, const Medium& medium);

/// Of a drawing that loses more than this it is said that it is not fit to be felt in this size: less than two thirds of what a
/// reader should find is no longer the drawing. This project's own number.
inline constexpr double kLegible = 2.0 / 3;

/// What a transcriber would want to know, a sentence each: "2 lines were moved by up to 0.8 mm." Nothing without changes.
std::vector<Phrase> notes_of(const Repaired& repaired);

}  // namespace tactics
