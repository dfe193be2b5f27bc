// SPDX-License-Identifier: Apache-2.0
// The page that is checked: read from a drawing, or made of a picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/chain.h"
#include "tactics/job/table_wish.h"
#include "tactics/medium.h"
#include "tactics/readers/svg/svg.h"

namespace tactics {

/// What `check` needs to know to come to a page.
struct PageWish {
    const Medium* medium = nullptr;
    std::optional<Paper> paper;             ///< of a picture (A4 if none), or of a drawing that tells no size
    std::optional<double> margin;           ///< mm; the medium's if none
    RecipeWish chain;                       ///< how a picture becomes a drawing
    TableWish table = {};                   ///< how a table is drawn
    std::vector<std::string> allowed = {};  ///< of kAskedFormats
    int pdf_page = 0;                       ///< of a PDF; 0: its first
};

/// SVG and PDF are read, whatever else is a picture and becomes a page as convert makes it. What the file holds decides, not
/// its name; "-" is standard input. Throws Error.
FoundPage page_of(const std::string& file, const PageWish& wish);

}  // namespace tactics
