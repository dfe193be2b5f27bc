// SPDX-License-Identifier: Apache-2.0
// A medium as a channel: what it can hold, and what of a scene comes through (sections 3.1 and 4 of K. Moustakas, "Handling
// haptics as a stand-alone medium", WSCG 2013).
#pragma once

#include <string>
#include <vector>

#include "tactics/information/scene.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A page, a machine or a device by what limits it. Lengths in mm, forces in N.
struct MediumChannel {
    std::string name = {}, kind = {};  ///< "graphiti", "display"
    double width = 0, height = 0;      ///< workspace, either way up; 0: as large as anybody likes
    double pitch = 1;                  ///< from one place that it tells apart to the next
    int levels = 2;                    ///< heights with the ground, where they are so many
    double step = 0, travel = 0;       ///< where they are a length: from one to the next, and all of it; else 0
    double most_force = 0;             ///< 0: nothing pushes back
    double least_apart = 0;            ///< from the middle of a line to that of another, to be felt as two; 0: not known
    double shortest = 0;               ///< of a line that is felt as one; 0: not known

    /// Whether the same fits on both: a scene loses as much.
    bool holds_the_same(const MediumChannel& other) const {
        return width == other.width && height == other.height && pitch == other.pitch && levels == other.levels &&
               step == other.step && travel == other.travel;
    }
};

/// How a scene is on a medium.
struct Fit {
    double scale = 1;  ///< mm there for a mm of the scene
    int longest = 1;   ///< cells along the longer side that its places can tell apart, at most those of the scene
    int levels = 2;    ///< of heights, at most those of the scene
};
Fit fit_of(const MeasuredScene& scene, const MediumChannel& channel);

struct Carried {
    Fit fit;
    int columns = 0, rows = 0;  ///< cells that the scene has there
    /// Bits that so many cells of so many levels can hold, as many as the workspace has for the shape of the scene.
    double capacity = 0;
    /// C(M) = min(C(M(W)), H(W)) (equation 3): of the capacity, of the scene (Measures::high) and of what the filter leaves of
    /// it (Pyramid::most_bits), the least.
    double bits = 0;
    double ratio = 0;               ///< C / H (equation 4)
    double loss = 0;                ///< max(H - C, 0) / H (equation 5)
    std::vector<Phrase> lost = {};  ///< in words; empty: nothing
};

/// What comes through. A channel whose pitch, step and workspace are no worse than another's never loses more. Throws
/// std::logic_error for a scene of 0 bits, of which nothing can be lost.
Carried carried_by(MeasuredScene& scene, const MediumChannel& channel);

}  // namespace tactics
