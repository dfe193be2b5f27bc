// SPDX-License-Identifier: Apache-2.0
// Gradients of a picture at a scale, shared by the edge filters.
//
// All strengths are calibrated: the height in grey levels of the straight step edge that would give this response.
#pragma once

#include <vector>

#include "tactics/image.h"

namespace tactics {

/// The factor from a central difference (levels per pixel) after a Gaussian of `sigma` pixels to a step's height: the difference
/// spans two pixels, so a step of height h gives h erf(1 / (sigma sqrt 2)) / 2 at its middle.
double step_height_per_slope(double sigma);

/// The direction of an angle of (-pi, pi] without its sign: in [0, pi), also after rounding.
float undirected(float angle);

/// The input of gradients: width*height floats in grey levels, where black to white is 255.
struct Plane {
    std::vector<float> values;
    double width = 1;  ///< relative width of its Gaussian: fine structure of this plane is less reliable
    double noise = 0;  ///< standard deviation of its noise, in grey levels, if measured
};

struct Planes {
    int width = 0;
    int height = 0;
    std::vector<Plane> planes;
};

Planes grey_plane(const Image& grey);

/// Perceptual planes of a picture: for colour, CIELAB lightness and `chroma_weight` times a* and b*, after stretching black and
/// white to the picture's own; in levels of the original picture, with the noise of each plane.
Planes see(const Image& picture, double chroma_weight);

/// Deviation of each component of the gradient of such planes' noise after a Gaussian of `sigma` pixels (noise_scale).
double noise_of_gradient(const Planes& planes, double sigma);

/// The gradient's second moments, summed over the planes: the structure tensor (J. Bigun and G. H. Granlund 1987; for
/// colour S. Di Zenzo 1986). Square grey levels, calibrated.
struct GradientTensor {
    int width = 0;
    int height = 0;
    std::vector<float> xx, xy, yy;  ///< width*height each
};

/// The moments of the gradient after a Gaussian of `sigma` pixels, times each plane's width.
GradientTensor gradient_tensor(Planes planes, double sigma);

/// The tensor's energy collected along lines: in each of kPoolingDirections directions the energy of the gradient across
/// the direction is averaged with a Gaussian of `along` pixels, and the strongest direction wins. Texture, whose gradients point
/// in all directions, fades; continuous contours stay. `along` 0: no averaging.
inline constexpr int kPoolingDirections = 8;
EdgeMap strongest_direction(const GradientTensor& tensor, double along, double mm_per_pixel);

}  // namespace tactics
