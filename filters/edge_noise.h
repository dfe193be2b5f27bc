// How strong an edge must be to be no noise: the floor under every threshold that follows the picture's own contrast.
//
// Such a threshold must draw something wherever it is used, on a flat wall too. What noise makes is known: the gradient's
// two components are normal, so the strengths of a flat noisy region follow a Rayleigh distribution of one scale, which
// tells how likely any strength is (H. Voorhees, T. Poggio, "Detecting textures and texture boundaries in natural images",
// ICCV 1987). The scale is read off the weakest quarter of the map, which is free of edges in all but the busiest pictures.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// The Rayleigh scale of the weakest quarter of the strengths, in grey levels. On a ramp, where all strengths are alike,
/// nearly that strength. Only for a map that is not thinned; whoever thins one keeps the answer in EdgeMap::noise.
float noise_of(const EdgeMap& edges);

/// Strength that noise reaches in one pixel of ten such pictures, if the detector mirrors the picture at its border; 0 for a
/// thinned map whose noise was not measured.
float noise_floor(const EdgeMap& edges);

/// Weaker strengths become 0.
void drop_below(EdgeMap& edges, float least);

}  // namespace tactics
