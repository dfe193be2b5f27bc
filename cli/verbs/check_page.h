// SPDX-License-Identifier: Apache-2.0
// The page to check: read from a drawing, or made from a picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/chain.h"
#include "tactics/job/table_wish.h"
#include "tactics/medium.h"
#include "tactics/readers/svg/svg.h"

namespace tactics {

/// The options of `check` that determine the page.
struct PageWish {
    const Medium* medium = nullptr;         ///< of what does not tell its own
    bool asks_medium = false;               ///< it holds for pages of ours, too, which tell theirs
    bool asks_margin = false;               ///< likewise
    std::optional<Paper> paper;             ///< of a picture (default: A4), or of a drawing that gives no size
    std::optional<double> margin;           ///< mm; the medium's if none
    RecipeWish chain;                       ///< how a picture becomes a drawing
    TableWish table = {};                   ///< how a table is drawn
    std::vector<std::string> allowed = {};  ///< of kAskedFormats
    int pdf_page = 0;                       ///< of a PDF; 0: its first
};

/// SVG and PDF are read as pages; everything else is a picture and becomes a page as convert makes it. The contents of the file
/// decide, not its name; "-" is standard input. Throws Error.
FoundPage page_of(const std::string& file, const PageWish& wish);

/// What that page is made on: as was asked for, as the page tells, or what is usual.
const Medium& medium_of(const Page& page, const PageWish& wish);

}  // namespace tactics
