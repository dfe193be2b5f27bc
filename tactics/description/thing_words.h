// SPDX-License-Identifier: Apache-2.0
// The things that a description tells: lines and areas, what each is and how they lie to each other.
#pragma once

#include "tactics/description/description.h"
#include "tactics/description/place_words.h"
#include "tactics/geometry/shape.h"

namespace tactics {

/// A line or an area before it has words.
struct Wordless {
    bool area = false;
    std::size_t index = 0;  ///< as of Thing
    double length = 0;
    Rect box;
    std::size_t last = 0;  ///< of a dashed line; else as index
};

std::vector<Wordless> candidates_of(const Page& page);
Shape shape_of(const Page& page, const Wordless& candidate);
Thing thing_of(const Page& page, const Wordless& candidate, const Shape& shape, const Ninths& ninths, double thinnest);
/// Of the last thing to those before it, but inside of any.
Phrase relations_of(const std::vector<Thing>& things, const std::vector<Shape>& shapes);

}  // namespace tactics
