// SPDX-License-Identifier: Apache-2.0
// A page of our own, read back from its SVG: as it is where nobody asks for another sheet, and its drawing where somebody does.
#pragma once

#include "tactics/job/job.h"
#include "tactics/layout/pages.h"

namespace tactics {

/// What the job leaves open is as on that page: its words, its braille and language; its medium, unless the format has
/// only dots and that has lines, and its paper on the same medium.
void take_own(Sheet& sheet, const Page& own, const Wishes& wishes, const Format& format);

/// A width, a scale, several sheets, a window, or paper of the same medium: the drawing then need not be as wide as on that page.
bool asks_for_other_size(const Sheet& sheet, const Page& own, const Wishes& wishes);

/// Where the page does not stay as it is: the drawing is as wide as on it, if the sheet has room for that and the job asks for no
/// other size.
void keep_size(Sheet& sheet, const Page& own, const Wishes& wishes);

/// Whether the page is what is wanted on such a sheet. Throws Error(usage) where another is and the page has no drawing that
/// could be laid out anew: one of text, or of a key.
bool stays_as_it_is(const Sheet& sheet, const Page& own, const Job& job, const Format& format);

/// That page, and behind it those of its key, if it has no room for that.
Pages pages_of_own(const Page& own, const DotHeights& dots);

/// What was laid out on it, its left top corner at (0, 0), with its labels and names, but without lead lines, scale bar and
/// patterns, which are of the layout. Dashes are whole lines.
Drawing drawing_of_page(const Page& own);

}  // namespace tactics
