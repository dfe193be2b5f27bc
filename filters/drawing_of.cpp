// SPDX-License-Identifier: Apache-2.0
#include "filters/drawing_of.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "filters/list.h"

namespace tactics {

namespace {

bool is_black_and_white(const Image& image) {
    return image.channels == 1 && std::all_of(image.pixels.begin(), image.pixels.end(),
                                              [](std::uint8_t sample) { return sample == 0 || sample == 255; });
}

// What is left of an edge map is ink.
Image ink_picture_of(const EdgeMap& edges) {
    Image image = make_image(edges.width, edges.height, 1, edges.mm_per_pixel, 255);
    for (std::size_t i = 0; i < edges.strength.size(); ++i)
        if (edges.strength[i] > 0) image.pixels[i] = 0;
    return image;
}

}  // namespace

Drawing drawing_of(Artwork artwork) {
    if (auto* drawing = std::get_if<Drawing>(&artwork)) return std::move(*drawing);
    if (const auto* edges = std::get_if<EdgeMap>(&artwork)) artwork = ink_picture_of(*edges);
    if (!is_black_and_white(std::get<Image>(artwork))) {
        const Step cut = parse_step("threshold", "threshold", filters());
        artwork = cut.filter->apply(std::move(artwork), cut.settings);
    }
    Drawing drawing;
    drawing.picture = std::get<Image>(std::move(artwork));
    drawing.width = drawing.picture->width * drawing.picture->mm_per_pixel;
    drawing.height = drawing.picture->height * drawing.picture->mm_per_pixel;
    return drawing;
}

}  // namespace tactics
