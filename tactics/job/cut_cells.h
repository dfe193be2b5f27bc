// SPDX-License-Identifier: Apache-2.0
// Eight-dot braille that is written in six-dot cells.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "print/format.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Counts the cells that lose dots 7 and 8, over all outputs of a picture.
class CutCells {
public:
    /// Adds the pages of one output. No effect for a format whose cells have eight dots.
    void count(const Format& format, const Settings& settings, const std::vector<Page>& pages);

    /// A message: what is lost, in which formats, and which formats have eight dots; empty: nothing is lost.
    Phrase note() const;

private:
    std::size_t most_ = 0;           // in one output
    std::set<std::string> formats_;  // that lose dots
};

}  // namespace tactics
