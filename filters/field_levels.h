// SPDX-License-Identifier: Apache-2.0
// The values of a field of colours as a few levels that a finger can tell.
#pragma once

#include <cstdint>
#include <vector>

#include "filters/colour_fields.h"
#include "filters/region_map.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct LevelWish {
    int most = 4;         ///< levels
    double smallest = 8;  ///< pixels: narrower regions join a neighbour, or are widened at its cost
};

struct FieldLevels {
    std::vector<double> limits;  ///< positions on the scale between levels; without those that the field does not reach
    ClassMap map;                ///< of the field's box: 0 is the lowest level
    std::vector<bool> marked;    ///< pixels that are in no colour of the scale: curves and marks on it
    std::vector<double> values;  ///< positions on the scale
    double lost = 0;             ///< share of the field that is not drawn in the level of its value
};

/// Levels of equal height. `ticks`: positions on the scale that have marks; limits go to those if they are near. Regions that are
/// too small to be felt join their neighbours.
FieldLevels field_levels_of(const Image& picture, const ColourField& field, const std::vector<double>& ticks,
                            const LevelWish& wish);

/// The ticks of its bar.
std::vector<double> ticks_of(const Image& picture, const ColourField& field);

/// Why the picture is one of fields whose colours stand for values; empty: it is not surely so.
Phrase levels_told(const Image& picture);

}  // namespace tactics
