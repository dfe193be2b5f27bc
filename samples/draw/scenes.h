// SPDX-License-Identifier: Apache-2.0
// The pictures that the project draws for itself: for its examples, its tests and its benchmarks.
//
// The set is that of the first pilot study with such pages: faces, a hot air balloon and a human heart, all oval, and a
// house, a laptop computer and the launch of a space shuttle. They look like photographs (shaded, textured, noisy), so
// that what works on them is not only what works on clip art. A map, a chart and a line drawing stand for the rest.
#pragma once

#include <span>
#include <string_view>

#include "tactics/image.h"

namespace tactics::samples {

struct Scene {
    std::string_view name;   ///< "face-anna"; the file is NAME.jpg for a photograph, else NAME.png
    std::string_view title;  ///< "Face of a woman with long hair"
    bool photograph = false;
    Image (*draw)(int size) = nullptr;
};

std::span<const Scene> scenes();

/// In colour, the longer side `size` pixels (at least 16). The same pixels every time, on any thread.
/// Throws std::logic_error for a name that is not in scenes().
Image draw_scene(std::string_view name, int size);

}  // namespace tactics::samples
