// SPDX-License-Identifier: Apache-2.0
// The arrangement of a sheet: the page without its drawing.
#pragma once

#include "tactics/layout/sheet.h"
#include "tactics/layout/tiles.h"
#include "tactics/layout/title.h"

namespace tactics {

/// The place of a drawing of that shape (width / height) on the sheet, and the sheet's orientation. It is known before the
/// picture is read, so that no more pixels are read than the page can show. Throws Error(usage) if nothing is left.
struct Place {
    double page_width = 0;
    double page_height = 0;
    Rect live;
    Rect drawing;
};
Place place_on(const Sheet& sheet, double aspect);

/// The result of place_on, and the placed title.
struct Arrangement {
    Place place;
    std::string title;
    std::string caption;
    TitleBand band;
    Rect scale_bar;          ///< room reserved for it at the bottom
    std::optional<Cut> cut;  ///< for a page of several sheets; `place` is then on the large page
};
Arrangement arrange(const Sheet& sheet, double aspect);

}  // namespace tactics
