// SPDX-License-Identifier: Apache-2.0
// Print as it is told of: what it says, where it stands, and what becomes of it.
#pragma once

#include <string>

#include "tactics/drawing.h"

namespace tactics {

/// A piece of print in the report: its middle in the picture, in percent from the left and top.
struct ToldWords {
    std::string text;  ///< empty: it looks like print, and was not read
    double sureness = 0;
    double x = 0, y = 0;
    bool set = false;    ///< it is set in braille; otherwise a person must look at it
    Point wanted = {};   ///< preferred place of the braille, also in percent
    bool loose = false;  ///< anywhere near that place
    bool title = false;  ///< it is part of the page's title, and no name in the drawing
    bool out = false;    ///< it is not set, and taken out of the lines all the same, as no finger reads print
};

}  // namespace tactics
