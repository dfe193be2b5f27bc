// SPDX-License-Identifier: Apache-2.0
// Where a drawn picture is filled, and with what: one colour, or a hatch on white or on a colour.
#pragma once

#include <array>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// Grey levels 0 to 255 of each channel; a grey picture has three that are the same.
using MeanColour = std::array<double, 3>;

/// Whether an eye would take them for one colour.
bool alike(const MeanColour& a, const MeanColour& b);

/// The levels by which they differ in the channel in which they differ most.
double contrast(const MeanColour& a, const MeanColour& b);

struct FillKind {
    MeanColour colour{};  ///< the mean, with the lines of a hatch
    MeanColour behind{};  ///< without them
    bool hatch = false;
    double angle = 0, order = 0;  ///< of a hatch: twice its lines' angle, radians; how much all of them run one way, 0 to 1
};

bool same_kind(const FillKind& a, const FillKind& b);

struct FilledPart {
    int left = 0, top = 0;  ///< of the mask in the picture, pixels
    Image mask;             ///< 255 in the part, else 0; one in one colour ends a pixel before anything else begins
    FillKind kind;
    double width = 0;  ///< diameter of the largest disc in it, pixels
    int size = 0;      ///< pixels
};

/// In pixels of the picture.
struct FilledParts {
    std::vector<FilledPart> parts;  ///< hatches first
    MeanColour ground{};            ///< what things are drawn on
};

/// The ground goes on beyond the picture. `mm` is the size of a pixel on the page: a hatch is what has no room for a finger
/// between its lines, and a part as wide as a line is none.
FilledParts filled_parts_in(const Image& picture, double mm);

}  // namespace tactics
