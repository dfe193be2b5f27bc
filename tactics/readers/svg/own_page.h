// SPDX-License-Identifier: Apache-2.0
// A page that we wrote as SVG, read back: the page itself where nobody has touched it, and what a person changed in a drawing
// program taken over.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct OwnPage {
    Page page;
    std::vector<Phrase> notes;  ///< what a person must look at
};

/// Nothing: the file is of another maker, or of another version of ours, or a program has taken away what it told.
///
/// Lines and areas that were taken out are gone, and their like that were drawn are in it: in a layer of lines as lines of that
/// layer. Words that were moved or typed anew have their braille there, in the page's table; texts that were added become words.
/// Throws Error(failed) where it is no SVG, and Error(usage) for words that the table has no cells for.
std::optional<OwnPage> read_own_page(std::string_view bytes, const std::string& file);

}  // namespace tactics
