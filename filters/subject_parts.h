// SPDX-License-Identifier: Apache-2.0
// The drawing when a person has named a subject: the subject first, the rest with the remaining line.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "filters/outline_choice.h"
#include "tactics/region_tree.h"
#include "tactics/spot.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The named things. Each spot is a separate thing; where two overlap, the one named later gets the shared part.
struct NamedThings {
    std::vector<std::uint32_t> of_face;  ///< 0: none; else the number of the spot, from 1
    std::vector<double> share;           ///< of the picture, what each spot's thing has in the end
    std::vector<bool> found;             ///< of each spot, whether something closed is there; a later one may have all of it

    bool any() const;
};

NamedThings find_things(const RegionTree& tree, std::span<const float> chances, std::span<const Spot> spots);

/// "found, 23 % of the picture"; "no closed thing was found at 40%,50%: draw a box around it".
Phrase words_of(const NamedThings& things, std::span<const Spot> spots);

/// The things whole, of the lines inside of them what is worth it up to 60 % of their outlines, then, if not `only` they are
/// wanted, others as parts_of_page has them. No part is in two things. `chances`: of each arc; no other is worth more for being
/// of a main thing, as the main things have been named.
Parts parts_with_things(const RegionTree& tree, std::span<const float> chances, double price, const NamedThings& things,
                        bool only, double line);

/// Sides of pixels that may be drawn inside the things beside what of `parts` is; below 0 if there is more already.
double room_inside(const RegionTree& tree, const Parts& parts, const NamedThings& things);

}  // namespace tactics
