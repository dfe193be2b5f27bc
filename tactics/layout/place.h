// SPDX-License-Identifier: Apache-2.0
// Where things stand on a sheet: the page without its drawing.
#pragma once

#include "tactics/layout/sheet.h"
#include "tactics/layout/tiles.h"
#include "tactics/layout/title.h"

namespace tactics {

/// Where a drawing of that shape (width / height) will stand on the sheet, and which way up the sheet is. Known before
/// the picture is read, so that no more of it is read than the page can show. Throws Error(usage) if nothing is left.
struct Place {
    double page_width = 0;
    double page_height = 0;
    Rect live;
    Rect drawing;
};
Place place_on(const Sheet& sheet, double aspect);

/// What place_on tells and, besides, the title where it stands.
struct Arrangement {
    Place place;
    std::string title;
    std::string caption;
    TitleBand band;
    Rect scale_bar;          ///< the room at the bottom that is kept for it
    std::optional<Cut> cut;  ///< of a page of several sheets; `place` is on the large page then
};
Arrangement arrange(const Sheet& sheet, double aspect);

}  // namespace tactics
