// SPDX-License-Identifier: Apache-2.0
// A drawing laid out on a sheet: the page, or the pages that are printed of it.
#pragma once

#include "tactics/layout/pages.h"
#include "tactics/layout/place.h"
#include "tactics/layout/sheet.h"

namespace tactics {

/// The drawing is scaled to its place. Throws Error(usage) for a title that cannot be set in braille. Of several sheets it is
/// the large page before it is cut.
Page lay_out(const Drawing& drawing, const Sheet& sheet);

/// The same where the sheet has been arranged for a drawing of that shape.
Page lay_out(const Drawing& drawing, const Sheet& sheet, Arrangement arrangement);

/// That page, or the sheets it is cut into, and, behind it, the key of its names if it has no room there. All are of one size. On
/// the back of a sheet everything is moved sideways for the binding, and pages are put in the order of facing.h.
Pages pages_of(const Drawing& drawing, const Sheet& sheet);
Pages pages_of(const Drawing& drawing, const Sheet& sheet, Arrangement arrangement);

}  // namespace tactics
