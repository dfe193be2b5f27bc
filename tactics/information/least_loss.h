// SPDX-License-Identifier: Apache-2.0
// The transformation of a scene that loses least on a medium: t* = argmin HIL(S_t, C) of section 4 of the paper, as a search that
// ends.
#pragma once

#include "tactics/information/channel.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// What is done to a scene before the medium's own filter.
struct Transformation {
    int longest = 1;      ///< resampled to so many cells along the longer side
    int smoothing = 0;    ///< then smoothed over squares of 2 * smoothing + 1 cells
    double evenness = 0;  ///< then heights compressed so that each level is used: 0 as they are, 1 as often as each other
    bool operator==(const Transformation&) const = default;
};

struct LeastLoss {
    Transformation best;
    double plain = 0;  ///< loss (Carried::loss) of the medium's filter by itself
    double loss = 0;   ///< of what `best` makes of the scene; at most `plain`
    int levels = 2;    ///< that the medium has of them
    std::size_t tried = 0;
};

/// The scene as `transformation` makes it, in so many levels.
LevelGrid transformed(MeasuredScene& scene, const Transformation& transformation, int levels);

/// The same as heights, mm: what the medium can then hold.
HeightMap transformed_heights(MeasuredScene& scene, const Transformation& transformation, int levels);

/// Tries three sizes, two smoothings and five strengths of compression, 30 in all, until one loses no more than the capacity
/// must; lines are only resampled, as they have no heights to compress. Equal losses: the one that changes less. Of more than
/// about 800,000 cells strips of half of them or less are compared, and then the whole of the three that are best on them, of
/// which `loss` is told.
LeastLoss least_loss(MeasuredScene& scene, const MediumChannel& channel);

/// What was found and why it was chosen, for the user: "least loss 80.1 % instead of 93 %, heights evened by 25 % (30 tried)".
Phrase explained(const LeastLoss& least, const LevelGrid& whole);

}  // namespace tactics
