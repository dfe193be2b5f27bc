// SPDX-License-Identifier: Apache-2.0
// A large page cut into sheets that are laid together.
#pragma once

#include <optional>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics {

/// Where the cuts are. All sheets are alike: the part of the large page that each shows stands in the same place on it.
struct Cut {
    double width = 0, height = 0;  ///< of a sheet, mm
    Rect live;                     ///< of a sheet
    Rect window;                   ///< on each sheet; of the large page, what the first one shows
    double across = 0, down = 0;   ///< from one sheet's part to the next; what is left of the window is on both
    Rect whole;                    ///< of the large page: all windows together
};

/// The windows are as large as `live` allows besides the marks, and whole cells and lines apart, so that the dots of an
/// embosser meet. Nothing if too little is left.
std::optional<Cut> cut_of(double width, double height, const Rect& live, const Sheet& sheet);

/// The part of the large page on each sheet, row by row.
std::vector<Rect> windows_of(const Cut& cut, const Sheet& sheet);

/// The sheets, row by row. Everything within its window is on a sheet, exactly; a braille cell only if it is there as a
/// whole, which is so on one sheet at least. Beside the window each has marks at the middle of what it shares with its
/// neighbours, and its row as a letter and its column as a digit, in braille (in print if the sheet is to have no braille).
std::vector<Page> cut_up(const Page& page, const Cut& cut, const Sheet& sheet);

}  // namespace tactics
