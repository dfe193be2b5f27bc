// SPDX-License-Identifier: Apache-2.0
// Lays out a drawing on a sheet: as one page, or as all pages to print.
#pragma once

#include <optional>

#include "tactics/layout/naming.h"
#include "tactics/layout/pages.h"
#include "tactics/layout/place.h"
#include "tactics/layout/sheet.h"

namespace tactics {

/// Scales the drawing to its place. Throws Error(usage) for a title that cannot be set in braille. For several sheets, returns
/// the large page before it is cut.
Page lay_out(const Drawing& drawing, const Sheet& sheet);

/// The same for a sheet that was already arranged for a drawing of that shape.
Page lay_out(const Drawing& drawing, const Sheet& sheet, Arrangement arrangement);

/// What the names on that page cost a hand; nothing if that is `most` or more.
std::optional<NamesCost> cost_of_names(const Drawing& drawing, const Sheet& sheet, Arrangement arrangement, double most);

/// That page, or the sheets it is cut into, followed by the key if it has no room there. All have one size. On the backs of
/// sheets everything is shifted sideways for the binding, and pages are in the order of facing.h.
Pages pages_of(const Drawing& drawing, const Sheet& sheet);
Pages pages_of(const Drawing& drawing, const Sheet& sheet, Arrangement arrangement);

}  // namespace tactics
