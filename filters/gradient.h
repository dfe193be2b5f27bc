// Gradients of a picture at a scale: what the edge filters share.
//
// All strengths are calibrated: the height in grey levels of the straight step edge that would give this answer.
#pragma once

#include <vector>

#include "tactics/image.h"

namespace tactics {

/// The factor from a central difference (levels a pixel) behind a Gaussian of `sigma` pixels to a step's height: the
/// difference spans two pixels, so a step of height h answers with h erf(1 / (sigma sqrt 2)) / 2 at its middle.
double step_height_per_slope(double sigma);

/// The direction of an angle of (-pi, pi] without its sign: in [0, pi), also after rounding.
float undirected(float angle);

/// What gradients are taken of: planes of width*height floats in grey levels, black to white being 255.
struct Planes {
    int width = 0;
    int height = 0;
    std::vector<std::vector<float>> values;
};

Planes grey_plane(const Image& grey);

/// As the eye sees a picture: for colour CIELAB, lightness and `chroma_weight` times a* and b*, after black and white have been
/// made the picture's own; in levels of the picture as it was.
struct Seen {
    Planes planes;
    double noise = 0;  ///< deviation of the picture's noise, of all planes together, in grey levels
};
Seen see(const Image& picture, double chroma_weight);

/// The gradient's second moments, summed over the planes: the structure tensor (J. Bigun and G. H. Granlund 1987; for
/// colour S. Di Zenzo 1986). Square grey levels, calibrated.
struct GradientTensor {
    int width = 0;
    int height = 0;
    std::vector<float> xx, xy, yy;  ///< width*height each
};

/// The moments of the gradient behind a Gaussian of `sigma` pixels.
GradientTensor gradient_tensor(Planes planes, double sigma);

/// The tensor's energy collected along lines: in each of kPoolingDirections directions the energy of the gradient across
/// the direction is averaged with a Gaussian of `along` pixels, and the strongest direction wins. Texture, whose
/// gradients point all ways, fades; contours, which go on, stay. `along` 0: no averaging.
inline constexpr int kPoolingDirections = 8;
EdgeMap strongest_direction(const GradientTensor& tensor, double along, double mm_per_pixel);

}  // namespace tactics
