// SPDX-License-Identifier: Apache-2.0
// Regions that nest, from a picture: every boundary whole, and a measure of how much each is one.
#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/enlarged.h"
#include "filters/frame.h"
#include "filters/map_choice.h"
#include "filters/opencv.h"
#include "filters/region_tree_of.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

// A fingertip is about 8 mm across; what is smaller has no inside that could be felt.
constexpr Option kNestOptions[] = {
    {.name = "map",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 2,
     .summary =
         "learned: contours as people draw them, by a small net; plain: without training; auto: learned if its file is installed",
     .choices = "auto learned plain"},
    {.name = "smallest",
     .type = Option::Type::length,
     .fallback = 8,
     .min = 0,
     .max = 100,
     .unit = "mm",
     .summary = "side of the smallest square that forms its own region"},
};

ChosenSetting settle_nest(const Artwork&, Settings& settings) { return settle_map(settings, "nest"); }

// Regions, and what they are judged by, depend on how many pixels they have. In a copy of fewer pixels they shall be the same.
Image as_large_as_scene(Image picture) {
    const double scale = kSceneSide / std::max(picture.width, picture.height);
    if (scale <= 1) return picture;
    const auto grown = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * scale))); };
    return enlarged(picture, grown(picture.width), grown(picture.height));
}

// A thing of straight edges on plain ground is no picture on a page: what is within bars must be most of it. Where a bar ends,
// pixels are a mixture of both, by JPEG and by how the picture was brought to its size; they are no part of the scene.
PixelBox scene_within(const Image& image) {
    constexpr double kMost = 0.5;
    constexpr int kMixed = 2;
    const PixelBox all = all_of(image.width, image.height), inside = picture_within(image);
    if (static_cast<double>(inside.width()) * inside.height() < kMost * image.width * image.height) return all;
    const auto mixed = [](bool bar) { return bar ? kMixed : 0; };
    const PixelBox scene{inside.left + mixed(inside.left > 0), inside.top + mixed(inside.top > 0),
                         inside.right - mixed(inside.right < image.width), inside.bottom - mixed(inside.bottom < image.height)};
    return scene.width() > 0 && scene.height() > 0 ? scene : all;
}

// Bars and borders around a picture are no part of the scene: it goes on in them as it ends, so that there is no line along them.
Image without_bars_nest(Image image, const PixelBox& inside) {
    if (inside == all_of(image.width, image.height)) return image;
    const cv::Rect part(inside.left, inside.top, inside.width(), inside.height());
    const cv::Mat within = view_of(image)(part).clone();
    cv::Mat all = view_of(image);
    cv::copyMakeBorder(within, all, inside.top, image.height - inside.bottom, inside.left, image.width - inside.right,
                       cv::BORDER_REPLICATE);
    return image;
}

Artwork apply_nest(Artwork artwork, const Settings& settings) {
    Image image = std::get<Image>(std::move(artwork));
    const PixelBox inside = scene_within(image);
    const int width = image.width, height = image.height;
    const Image picture = as_large_as_scene(without_bars_nest(std::move(image), inside));
    const auto net = net_for(settings);
    const double side = picture.mm_per_pixel > 0 ? settings.number("smallest") / picture.mm_per_pixel : 0;
    RegionTree tree = region_tree_of(picture, contour_maps_of(picture, net.get()), side * side, pair_weights(net != nullptr));
    tree.mm_per_pixel = picture.mm_per_pixel;
    tree.learned = net != nullptr;
    const auto grown = [](int pixels, int from, int to) {
        return static_cast<int>(std::lround(static_cast<double>(pixels) * to / from));
    };
    tree.inside = {grown(inside.left, width, picture.width), grown(inside.top, height, picture.height),
                   grown(inside.right, width, picture.width), grown(inside.bottom, height, picture.height)};
    return tree;
}

}  // namespace

extern const Filter nest_filter;
const Filter nest_filter{
    .name = "nest",
    .summary = "divides a photograph into nested regions, each with a whole outline",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::regions),
    .uses_colour = true,
    .options = kNestOptions,
    .apply = apply_nest,
    .settle = settle_nest,
    .in_full = "contours",
};

}  // namespace tactics
