// SPDX-License-Identifier: Apache-2.0
// Flat drawing with smooth edges: lines, filled shapes and letters, for what is drawn and not photographed.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tactics/image.h"

namespace tactics::samples {

struct Spot {
    float x = 0, y = 0;
};

struct Colour {
    int red = 0, green = 0, blue = 0;
};

/// Places and widths are in units: the longer side of the picture is 1000 of them, origin at the top left.
class Ink {
public:
    Ink(int width, int height, Colour ground);

    void line(std::span<const Spot> points, float width, Colour colour, bool closed = false);
    void fill(std::span<const Spot> points, Colour colour);
    void disc(Spot centre, float radius, Colour colour);
    void box(float left, float top, float width, float height, Colour colour);
    /// Capitals, figures and `. , - %`; lower case is written as capitals. `size` is the height of a letter.
    void text(Spot left_base, float size, std::string_view words, Colour colour, float weight = 0.12f);

    Image take() && { return std::move(image_); }

private:
    void blend(int x, int y, float cover, Colour colour);
    Image image_;
    float scale_;
};

/// A smooth curve through the points, as a polyline (Catmull-Rom).
std::vector<Spot> curve(std::span<const Spot> through, bool closed = false);
std::vector<Spot> oval(Spot centre, float rx, float ry, float from_degrees = 0, float to_degrees = 360);

}  // namespace tactics::samples
