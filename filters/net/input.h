// SPDX-License-Identifier: Apache-2.0
// The input of the net: the normalised colours of a picture, and fixed derivatives.
#pragma once

#include <array>
#include <cstdint>

#include "filters/net/net.h"
#include "filters/net/plane.h"
#include "tactics/image.h"

namespace tactics {

/// The net's input for each sample level: minus the picture's mean luminance, times one gain that normalises contrast within
/// bounds; 8 bits of fraction, within 5100.
using NetLevels = std::array<std::int16_t, 256>;

NetLevels net_levels(const Image& image);

/// The reach of an input sample, in samples: the widest Gaussian before the derivatives, and the difference of two neighbours.
inline constexpr int kInputReach = 12 + 1;

/// Fills `input`, 24 channels at half size, with the part of the picture that begins at pixel (left, top); what lies beyond the
/// picture is its mirror image. 12 channels are 2 x 2 pixels of blue, green and red, 12 are derivatives.
void see(const Image& image, const NetLevels& levels, int left, int top, NetPlane& input);

/// As logits_of() in net.h, with the levels of the picture at its own size: what was resized is not evened out anew.
ContourLogits logits_of(const ContourNet& net, const Image& image, const NetLevels& levels, const NetRun& run);

}  // namespace tactics
