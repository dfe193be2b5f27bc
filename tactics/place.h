// Where things stand on a sheet: the page without its drawing.
#pragma once

#include "tactics/page.h"
#include "tactics/tiles.h"
#include "tactics/title.h"

namespace tactics {

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
