// Ridges of an edge map: thin lines where the strength is greatest, and the cut that keeps the connected ones.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Non-maximum suppression: keeps a pixel only where its strength is greatest across the edge (J. Canny 1986) and falls
/// off to both sides within `sigma` pixels, the blur that the map was made with. The map must have normals.
EdgeMap thin_edges(const EdgeMap& edges, double sigma);

/// Hysteresis (J. Canny 1986): keeps the 8-connected pieces of strength >= low that reach `high` somewhere;
/// everything else becomes 0.
EdgeMap keep_connected(EdgeMap edges, float low, float high);

/// Deviation of a picture's own noise in grey levels, from the finest structure there is (J. Immerkaer 1996, with the
/// median instead of the mean so that drawn edges do not count).
double noise_level(const Image& grey);

/// Deviation of each component of the calibrated answer to noise of deviation `level` behind a Gaussian derivative of
/// `sigma` pixels: level / (2 sigma). The strength is their length, so it has a Rayleigh distribution of this scale.
double noise_scale(double level, double sigma);

}  // namespace tactics
