// SPDX-License-Identifier: Apache-2.0
// The level of detail at which a page of a medium loses least of what people would draw: --detail best.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/artwork.h"
#include "tactics/layout/sheet.h"
#include "tactics/page.h"
#include "tactics/recipe.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct TriedDetail {
    double times = 1;        ///< the usual line of the recipe, within what its filter takes
    double line = 0;         ///< mm that are left of it when it is mended for the medium
    double agreed = 0;       ///< share of these that people would draw
    double loss = 1;         ///< AgreedBits::loss
    std::size_t broken = 0;  ///< places that break a hard rule still
};

struct DetailChoice {
    std::vector<TriedDetail> tried;  ///< from little to much line
    std::size_t best = 0;            ///< the least broken; of these the least loss; of about equals the nearest to the usual line
    const TriedDetail& chosen() const { return tried.at(best); }
};

/// Throws Error(usage) for a recipe whose lines do not say how likely people would draw them.
void check_chooses_detail(const Recipe& recipe);

/// Puts the chosen amount of line into `recipe`, which is fitted to the medium of `sheet`. `picture` is what it begins with,
/// `place` that of the drawing. The steps before the one that has a budget of line are taken once.
DetailChoice choose_detail(Recipe& recipe, Artwork picture, const Sheet& sheet, const Rect& place, bool as_drawn);

/// For the user: what was taken for `medium`, what is lost of the bits about what people would draw, and what with less and more.
Phrase explained(const DetailChoice& choice, const Medium& medium);
/// For whoever has the page described.
Phrase remark_on(const DetailChoice& choice);

}  // namespace tactics
