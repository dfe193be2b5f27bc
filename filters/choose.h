// Which recipe suits a picture: what `--recipe auto` asks.
#pragma once

#include <string>

#include "tactics/image.h"

namespace tactics {

/// What a look at the picture counts. Shares are of all pixels, 0 to 1.
struct Traits {
    double flat = 0;       ///< where the 3x3 neighbours differ by no more than the picture's noise
    double few = 0;        ///< in the eight highest peaks of the histogram of greys
    double two_tone = 0;   ///< near one of the two ends of the grey scale that the picture uses
    double paper = 0;      ///< in the commonest colour (of 16x16x16)
    double colourful = 0;  ///< clearly not grey
    int greys = 0;         ///< grey levels that are used at all (each by more than one pixel in 5,000)
};

Traits traits_of(const Image& picture);

struct Choice {
    std::string recipe;
    std::string reason;  ///< "continuous tones: 214 grey levels, 31 % flat": to be told to the user
};

Choice choose_recipe(const Image& picture);

}  // namespace tactics
