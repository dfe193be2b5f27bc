// SPDX-License-Identifier: Apache-2.0
// A page that a file holds, with what the file tells of it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// Letters of the file, as far as it tells what they say.
struct FoundWords {
    std::string text;   ///< UTF-8
    Point middle;       ///< mm on the page
    double height = 0;  ///< of the letters, mm
    bool upwards = false;
    double width = 0;                 ///< along the line, mm
    std::optional<Point> thing = {};  ///< what they name is there; nothing: it is where they stand
};

/// How one element of a figure is painted, and which strokes and areas of the page are its.
struct FoundLook {
    std::size_t stroke = 0, strokes_end = 0, area = 0, areas_end = 0;
    double line = -1, fill = -1;  ///< lightness, which tells colours of one figure apart; -1: none
    std::size_t dashes = 0;       ///< in the page's dash_kinds; 0: a whole line
};

/// A page that was not laid out here: positions may lie off the paper, lines may be thinner than any medium's.
struct FoundPage {
    Page page;
    /// What the file has and the page has not, or has in another way: "2 texts are letters, which no rule looks at".
    std::vector<std::string> notes;
    std::vector<FoundWords> words = {};
    std::vector<FoundLook> looks = {};                   ///< of a figure
    bool tells_size = true;                              ///< in mm, cm, in or pt; pixels are for screens
    std::map<std::string, std::size_t> dash_kinds = {};  ///< a number for each, from 1: as the file has it, which may be long
};

}  // namespace tactics
