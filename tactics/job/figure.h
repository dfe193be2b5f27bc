// SPDX-License-Identifier: Apache-2.0
// Figures that are lines already, for convert: an SVG beside pictures.
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include "tactics/job/print_words.h"
#include "tactics/layout/sheet.h"
#include "tactics/readers/read.h"
#include "tactics/readers/svg/svg.h"

namespace tactics {

enum class Holds { svg, pdf, other };
Holds look_at(std::FILE* file);         ///< what is in it, whatever its name says; rewinds it
std::string bytes_of(std::FILE* file);  ///< all, up to what an SVG may have and a little more

/// An SVG and its words.
struct Figure {
    FoundPage page;
    PrintWords words;

    double aspect() const { return page.page.width / page.page.height; }
};

/// Nothing: the file is no SVG. Throws Error(failed).
std::optional<Figure> figure_of(Source& source, WordsWish wish, const Sheet& sheet);

}  // namespace tactics
