// SPDX-License-Identifier: Apache-2.0
// Grows and shrinks ink by a disc: joins broken lines, drops thin ones, keeps the rest as wide as it was.
//
// A disc is not a product of a row and a column, so it is taken row by row: the darkest pixel within h to the left and right
// is made from the one within h-1, and serves every row of the disc that is 2h+1 wide. 4 r steps a pixel instead of pi r^2,
// each on whole rows.
#include <algorithm>
#include <cmath>

#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kMorphologyOptions[] = {
    {.name = "operation",
     .type = Option::Type::choice,
     .fallback = 3,
     .min = 0,
     .max = 3,
     .summary = "dilate thickens ink, erode thins it, open drops ink thinner than the disc, close fills gaps narrower than it",
     .choices = "dilate erode open close"},
    {.name = "radius",
     .type = Option::Type::length,
     .fallback = 0.5,
     .min = 0,
     .max = 10,
     .unit = "mm",
     .summary = "radius of the disc; no effect under 1 pixel"},
};

using Row = std::vector<std::uint8_t>;

std::uint8_t darker(std::uint8_t a, std::uint8_t b) { return a < b ? a : b; }

void take_darker(std::uint8_t* to, const std::uint8_t* from, int count) {
    for (int i = 0; i < count; ++i) to[i] = darker(to[i], from[i]);
}

// From the darkest within h-1 of each pixel to the darkest within h.
void widen(Row& row, Row& wider) {
    const int width = static_cast<int>(row.size());
    wider = row;
    take_darker(wider.data() + 1, row.data(), width - 1);
    take_darker(wider.data(), row.data() + 1, width - 1);
    row.swap(wider);
}

// Every pixel becomes the darkest of the disc around it. Nothing is taken from outside the picture.
Image darkest_of_disc(const Image& image, double radius) {
    Image result = make_image(image.width, image.height, 1, image.mm_per_pixel, 255);
    const int reach = static_cast<int>(std::min(radius, std::hypot(image.width, image.height)));
    const auto half_width = [&](int dy) { return static_cast<int>(std::sqrt(radius * radius - static_cast<double>(dy) * dy)); };
    Row row;
    Row wider;
    for (int y = 0; y < image.height; ++y) {
        row.assign(image.row(y), image.row(y) + image.width);
        int half = 0;
        for (int dy = reach; dy >= 0; --dy) {
            for (const int needed = std::min(half_width(dy), image.width); half < needed; ++half) widen(row, wider);
            if (y >= dy) take_darker(result.row(y - dy), row.data(), image.width);
            if (dy > 0 && y + dy < image.height) take_darker(result.row(y + dy), row.data(), image.width);
        }
    }
    return result;
}

void invert(Image& image) {
    for (auto& sample : image.pixels) sample = static_cast<std::uint8_t>(255 - sample);
}

Image lightest_of_disc(Image image, double radius) {
    invert(image);
    image = darkest_of_disc(image, radius);
    invert(image);
    return image;
}

Artwork apply_morphology(Artwork artwork, const Settings& settings) {
    Image image = to_grey(std::move(std::get<Image>(artwork)));
    const double radius = settings.number("radius") / image.mm_per_pixel;
    if (radius < 1) return image;
    const auto operation = settings.choice("operation");
    if (operation == "dilate") return darkest_of_disc(image, radius);
    if (operation == "erode") return lightest_of_disc(std::move(image), radius);
    if (operation == "open") return darkest_of_disc(lightest_of_disc(std::move(image), radius), radius);
    return lightest_of_disc(darkest_of_disc(image, radius), radius);
}

}  // namespace

extern const Filter morphology_filter;
const Filter morphology_filter{
    .name = "morphology",
    .summary = "grows or shrinks ink by a disc",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::picture),
    .options = kMorphologyOptions,
    .apply = apply_morphology,
};

}  // namespace tactics
