// SPDX-License-Identifier: Apache-2.0
// Braille of eight dots that is written in cells of six.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "print/format.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Counts the cells that lose dots 7 and 8, over the outputs of a picture.
class CutCells {
public:
    /// The pages of one output. Without effect for a format whose cells have eight dots.
    void count(const Format& format, const Settings& settings, const std::vector<Page>& pages);

    /// What is lost, in which formats, and what has eight dots; empty: nothing.
    Phrase note() const;

private:
    std::size_t most_ = 0;           // in one output
    std::set<std::string> formats_;  // that cut
};

}  // namespace tactics
