// SPDX-License-Identifier: Apache-2.0
// A drawing mended for its page, and what is told of that.
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
    bool measured = false;      ///< false: it was left as it was drawn, and nothing is known of it
    bool complete = true;       ///< false: there is so much in it that not all was looked at
    std::vector<Mend> changes;  ///< where, in the drawing
    std::vector<Phrase> notes;  ///< the same as sentences
    std::size_t broken_before = 0;
    std::size_t broken_after = 0;
    double kept = 1;                  ///< share of the lines
    std::optional<Trust> trust = {};  ///< as the drawing had it
    Phrase doubt;                     ///< why people would hardly agree with it, and what to do; empty: they may
    Phrase advice;                    ///< what to do about a drawing that is not fit to be felt in this size; empty: it is
};

struct Mended {
    Drawing drawing;
    MendingTold told;
    Drawing before;  ///< in the same size, if mending did not make it fit to be felt
};

/// The drawing `width` mm wide and mended for a medium; untouched but for its size if it is wanted as it was drawn. Without
/// advice.
Mended mend_for(const Medium& medium, double width, Drawing drawing, bool as_drawn);

/// The page of such a drawing is told to need a look.
bool is_doubtful(const std::optional<Trust>& trust);

/// Adds the advice, if it needs any. A drawing that is only scaled to its sheet is tried on larger ones, each another repair.
/// That of a picture which is `finer` than this one shows has more lines on a larger sheet: what becomes of those is not
/// foretold.
void advise(const Sheet& sheet, Mended& mended, bool finer);

}  // namespace tactics
