// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_ground.h"

#include <cmath>

#include "tactics/readers/svg/clip.h"

namespace tactics {

namespace {

constexpr double kAllOfIt = 0.97;        // of width and height: some leave a margin
constexpr double kSameLightness = 0.02;  // lightness
constexpr std::size_t kCorners = 5;      // a rectangle, closed twice; what has more is an outline of something

bool covers(const std::vector<Subpath>& surface, const Page& page) {
    if (surface.size() != 1 || surface[0].points.size() > kCorners) return false;
    Extent extent;
    add_all(extent, surface);
    const Rect& box = extent.box;
    const Rect seen =
        common_of({0, 0, page.width, page.height}, {box.left, box.top}, {box.left + box.width, box.top + box.height});
    return seen.width >= kAllOfIt * page.width && seen.height >= kAllOfIt * page.height;
}

}  // namespace

bool Ground::takes(const std::vector<Subpath>& surface, Paint& fill, Paint& stroke, const Page& page) {
    if (!only_ && !fill.none && fill.opacity >= 0.5 && page.strokes.empty() && page.areas.empty() && covers(surface, page)) {
        lightness_ = fill.lightness;
        const bool framed = !stroke.none && stroke.opacity >= 0.5 && std::abs(stroke.lightness - *lightness_) >= kSameLightness;
        if (!framed) return true;
    }
    // A surface in the ground's own colour is not seen on it.
    if (lightness_ && std::abs(fill.lightness - *lightness_) < kSameLightness) fill.none = true;
    for (Paint* paint : {&fill, &stroke}) paint->lightness = on_white(paint->lightness);
    return false;
}

}  // namespace tactics
