// SPDX-License-Identifier: Apache-2.0
// Figures that consist of lines already, for convert: SVG.
#pragma once

#include <cstdio>
#include <string>

#include "tactics/job/print_words.h"
#include "tactics/layout/sheet.h"
#include "tactics/readers/read.h"
#include "tactics/readers/svg/svg.h"

namespace tactics {

std::string bytes_of(std::FILE* file);  ///< the whole file, up to slightly more than the limit of an SVG

/// An SVG and its words.
struct Figure {
    FoundPage page;
    PrintWords words;

    double aspect() const { return page.page.width / page.page.height; }
};

/// Reads a file that holds an SVG. Throws Error(failed).
Figure read_figure(Source& source, WordsWish wish, const Sheet& sheet);

}  // namespace tactics
