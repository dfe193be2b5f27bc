// SPDX-License-Identifier: Apache-2.0
// Mends a drawing for its page, and reports the changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/page.h"
#include "tactics/repair/repair.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct MendingTold {
    bool measured = false;      ///< false: the drawing was not mended, so nothing is known
    bool complete = true;       ///< false: the drawing has too much line to check all of it
    std::vector<Mend> changes;  ///< where, in the drawing
    std::vector<Phrase> notes;  ///< the same as sentences
    std::size_t broken_before = 0;
    std::size_t broken_after = 0;
    double kept = 1;                  ///< share of the lines that is left
    std::optional<Trust> trust = {};  ///< as the drawing had it
    Phrase doubt;                     ///< why people would hardly agree with it, and the remedy; empty: no doubt
    Phrase advice;                    ///< remedy for a drawing that is not fit to be felt at this size; empty: it is fit
};

struct Mended {
    Drawing drawing;
    MendingTold told;
    Drawing before;  ///< the unmended drawing in the same size, if mending did not make it fit to be felt
};

/// Scales the drawing to `width` mm and mends it for a medium; only scales it if it is wanted as drawn. Gives no advice.
Mended mend_for(const Medium& medium, double width, Drawing drawing, bool as_drawn);

/// Whether a person must look at the page of such a drawing.
bool is_doubtful(const std::optional<Trust>& trust);

/// Adds advice if it is needed. A drawing that is only scaled is tried on larger sheets, each with its own repair. A picture that
/// is `finer` than this drawing shows would have more lines on a larger sheet; these are not predicted.
void advise(const Sheet& sheet, Mended& mended, bool finer);

}  // namespace tactics
