// SPDX-License-Identifier: Apache-2.0
// Changes of a picture on its way to the user that should not change its drawing: storage, noise, light, a slight shift. Each
// change is a pure function with its inverse.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "tactics/image.h"
#include "tactics/measure/matching.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A changed picture, and where it lies in the picture that it was made of. Positions are in pixels of that one.
struct Disturbed {
    Image image;
    int width = 0;  ///< how large it is there; that is not its own size if it was made coarser
    int height = 0;
    double angle = 0;  ///< a point p of it was at turn(p, angle) + shift; radians
    double shift_x = 0, shift_y = 0;
};

struct Disturbance {
    SourceWords name;          ///< heading of its column
    std::string_view summary;  ///< what is done, for the help
    Disturbed (*apply)(const Image& image) = nullptr;
};

/// All of them, in the order of the columns. Noise has a fixed seed.
std::span<const Disturbance> disturbances();

/// Lines drawn on the disturbed picture, on a map of its width and height, put back onto the `width` x `height` pixels of the
/// picture that it was made of. What falls outside is left out.
PixelSet brought_back(const PixelSet& lines, const Disturbed& disturbed, int width, int height);

/// The lines drawn on the original that both pictures show, farther than `margin` from the border of either. Applied to both
/// sets, so that neither is penalised for parts that the other picture lacks.
PixelSet seen_by_both(const PixelSet& lines, const Disturbed& disturbed, double margin);

/// The picture with normal noise of that deviation in every sample, the same on every machine.
Image with_noise(Image image, double deviation, std::uint64_t seed);

}  // namespace tactics
