// SPDX-License-Identifier: Apache-2.0
// Contour maps of a picture, not thinned, from which regions are made.
#pragma once

#include "filters/net/net.h"
#include "tactics/image.h"

namespace tactics {

/// Of the picture's size, 0 to 255.
struct ContourMaps {
    EdgeMap fine;    ///< where the boundaries run
    EdgeMap coarse;  ///< how much they belong to the scene rather than its texture
};

/// The longer side at which scenes are analysed, in pixels: that of the photographs on which everything was fitted. Other
/// pictures are scaled to it, within bounds: for a net, to at least a tenth and at most four times their size, which is no
/// restriction from about 170 to 2400 pixels; without training, a picture is smoothed at least as much as one of 144 pixels.
inline constexpr double kSceneSide = 480;

/// The fine one by a net, with normals.
EdgeMap learned_map_of(const Image& picture, const ContourNet& net);

/// By a net (its chances, at two sizes, and at half size), or without training (nullptr).
ContourMaps contour_maps_of(const Image& picture, const ContourNet* net);

}  // namespace tactics
