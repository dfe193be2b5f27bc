// SPDX-License-Identifier: Apache-2.0
// Prints greys as dots: swell paper rises only where it is black, so a grey must become a share of black.
//
// The share follows the picture's levels as they are coded, which are about evenly spaced to the eye, so that equal steps
// of grey become equal steps of ink under the finger. (Printers for the eye would go through linear light.)
#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/filter.h"

namespace tactics {

namespace {

// 0.5 mm is the least width that one tool allows for lines on swell paper: smaller dots may be lost by the printer or not
// rise. Dots of 1 mm and more are felt one by one, as a texture.
constexpr Option kHalftoneOptions[] = {
    {.name = "method",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "diffusion scatters the dots and keeps detail, ordered places them in a regular pattern",
     .choices = "diffusion ordered"},
    {.name = "dot",
     .type = Option::Type::length,
     .fallback = 0.5,
     .min = 0,
     .max = 5,
     .unit = "mm",
     .summary = "side of the smallest dot, in whole pixels; under 2 pixels every pixel is a dot"},
};

// R. Floyd, L. Steinberg, "An adaptive algorithm for spatial greyscale", 1976, every other row from right to left.
void diffuse(Image& image) {
    // Errors in sixteenths of a level; one cell of margin on both sides.
    std::vector<int> here(static_cast<std::size_t>(image.width) + 2);
    std::vector<int> below(here.size());
    for (int y = 0; y < image.height; ++y) {
        std::uint8_t* row = image.row(y);
        const int step = y % 2 == 0 ? 1 : -1;
        std::fill(below.begin(), below.end(), 0);
        for (int i = 0; i < image.width; ++i) {
            const int x = step > 0 ? i : image.width - 1 - i;
            int* const at = here.data() + x + 1;
            int* const under = below.data() + x + 1;
            // Full black and full white take no dot of the other and pass on no debt of their neighbours.
            if (row[x] == 0 || row[x] == 255) continue;
            const int wanted = row[x] * 16 + *at;
            const bool white = wanted >= 128 * 16;
            const int error = (wanted - (white ? 255 * 16 : 0)) / 16;
            row[x] = white ? 255 : 0;
            at[step] += 7 * error;
            under[-step] += 3 * error;
            under[0] += 5 * error;
            under[step] += error;
        }
        here.swap(below);
    }
}

// B. Bayer, "An optimum method for two-level rendition of continuous-tone pictures", 1973: the 8 x 8 matrix, 0 to 63.
int bayer(int x, int y) {
    int value = 0;
    for (int bit = 1; bit < 8; bit *= 2) value = value * 4 + (((x ^ y) & bit) != 0 ? 2 : 0) + ((y & bit) != 0 ? 1 : 0);
    return value;
}

void weave(Image& image) {
    for (int y = 0; y < image.height; ++y) {
        std::uint8_t* row = image.row(y);
        std::array<int, 8> levels{};
        for (int x = 0; x < 8; ++x) levels[static_cast<std::size_t>(x)] = 4 * bayer(x, y) + 2;
        for (int x = 0; x < image.width; ++x) row[x] = row[x] > levels[static_cast<std::size_t>(x % 8)] ? 255 : 0;
    }
}

void dither(Image& image, std::string_view method) {
    if (method == "ordered")
        weave(image);
    else
        diffuse(image);
}

Artwork apply_halftone(Artwork artwork, const Settings& settings) {
    Image image = to_grey(std::move(std::get<Image>(artwork)));
    const auto method = settings.choice("method");
    const double side = std::min(std::floor(settings.number("dot") / image.mm_per_pixel),
                                 static_cast<double>(std::max(image.width, image.height)));
    if (side < 2) {
        dither(image, method);
        return image;
    }
    // One cell a dot, of the mean grey; the last row and column of dots may be cut by the edge of the picture.
    const int dot = static_cast<int>(side);
    Image cells = make_image((image.width + dot - 1) / dot, (image.height + dot - 1) / dot, 1, image.mm_per_pixel * dot, 0);
    for (int cy = 0; cy < cells.height; ++cy) {
        const int bottom = std::min(image.height, (cy + 1) * dot);
        for (int cx = 0; cx < cells.width; ++cx) {
            const int right = std::min(image.width, (cx + 1) * dot);
            std::uint64_t sum = 0;
            for (int y = cy * dot; y < bottom; ++y)
                for (int x = cx * dot; x < right; ++x) sum += image.row(y)[x];
            const auto area = static_cast<std::uint64_t>((bottom - cy * dot)) * static_cast<std::uint64_t>(right - cx * dot);
            cells.row(cy)[cx] = static_cast<std::uint8_t>((sum + area / 2) / area);
        }
    }
    dither(cells, method);
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* from = cells.row(y / dot);
        std::uint8_t* row = image.row(y);
        for (int x = 0; x < image.width; ++x) row[x] = from[x / dot];
    }
    return image;
}

}  // namespace

extern const Filter halftone_filter;
const Filter halftone_filter{
    .name = "halftone",
    .summary = "turns greys into black dots, for media that have no grey",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::picture),
    .options = kHalftoneOptions,
    .apply = apply_halftone,
};

}  // namespace tactics
