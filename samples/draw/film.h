// SPDX-License-Identifier: Apache-2.0
// The effects of a camera: lens, vignette, tone curve, grain.
#pragma once

#include <vector>

#include "samples/draw/vector.h"
#include "tactics/image.h"

namespace tactics::samples {

/// Linear light, row by row from the top left.
struct Light {
    int width = 0;
    int height = 0;
    std::vector<Vec3> pixels;
    Light(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    Vec3& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    const Vec3& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

struct Exposure {
    float gain = 1;
    float vignette = 0.35f;  ///< share of the light lost in the corners
    float grain = 0.018f;    ///< standard deviation of the sensor noise in mid-grey, of full scale
    float blur = 0.85f;      ///< sigma of the lens in pixels
    int seed = 1;
};

/// The photograph, 3 channels.
Image develop(Light light, const Exposure& exposure);

}  // namespace tactics::samples
