// SPDX-License-Identifier: Apache-2.0
// What tells a drawing from a photograph.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Measurements of the picture, on a small copy without grain and uneven light. Shares are of all places, 0 to 1.
struct Traits {
    double noise = 0;       ///< deviation that is left, in grey levels
    double flat = 0;        ///< where the 3x3 neighbours differ by no more than what is left of the noise
    double soft = 0;        ///< where they differ by more than that, but by no more than a soft shade or a texture
    double clear = 0;       ///< of all steps, those with a plain part on either side
    double few = 0;         ///< in one of the eight commonest colours
    double ground = 0;      ///< in the commonest colour
    double paper = 0;       ///< in one of the two commonest, if both are light and one is the border's: paper and panels on it
    double rim = 0;         ///< of the places along the border: in their commonest colour
    double colourful = 0;   ///< clearly of another hue than that
    double thick = 0;       ///< darker than the ground over more than a line's width
    double painted = 0;     ///< plain, darker than the ground, but light, over more than a line's width
    int range = 0;          ///< grey levels from the darkest to the lightest
    bool lightest = false;  ///< the ground is in the lightest fifth of that
    bool darkest = false;   ///< in the darkest fifth
};

Traits traits_of(const Image& picture);

}  // namespace tactics
