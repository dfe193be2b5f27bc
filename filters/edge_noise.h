// SPDX-License-Identifier: Apache-2.0
// The strength above which an edge is not noise: the lower limit of every threshold that adapts to the picture's contrast.
//
// Without a limit, such a threshold would draw something even on a flat wall. The strengths that noise causes are known: the
// gradient's two components are normal, so the strengths of a flat noisy region follow a Rayleigh distribution of one scale,
// which tells how likely any strength is (H. Voorhees, T. Poggio, "Detecting textures and texture boundaries in natural images",
// ICCV 1987). A detector measures the noise of its picture and tells the scale in EdgeMap::noise. Of a map that comes without,
// the scale is read off its weakest quarter, which is free of edges in all but the busiest pictures.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Deviation of a picture's own noise in grey levels, from the finest structure there is (J. Immerkaer 1996, with the
/// median instead of the mean so that drawn edges do not count). Blind to even slopes.
double noise_level(const Image& grey);

/// Deviation of each component of the calibrated response to noise of deviation `level` after a Gaussian derivative of `sigma`
/// pixels: level / (2 sigma). The strength is their length, so it has a Rayleigh distribution of this scale.
double noise_scale(double level, double sigma);

/// The Rayleigh scale of the weakest quarter of the strengths, in grey levels. Only for a map that is not thinned.
float noise_of(const EdgeMap& edges);

/// A ramp of 8-bit greys is a staircase of steps of 1; what is stronger by so much is more than a ramp.
inline constexpr float kStaircase = 2;

/// Strength that noise reaches in one pixel of ten such pictures, if the detector mirrors the picture at its border; `least`
/// at the least. It adds to the overall slope of the picture, as under uneven light: the rest of the weakest quarter of a map's
/// strengths after the noise is subtracted. A thinned map has lost its slopes, and 0 means that its noise was not measured.
float noise_floor(const EdgeMap& edges, float least = kStaircase);

/// Weaker strengths become 0.
void drop_below(EdgeMap& edges, float least);

}  // namespace tactics
