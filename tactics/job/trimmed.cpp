// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/trimmed.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/readers/svg/found_page.h"

namespace tactics {

namespace {

constexpr double kRim = 0.01;      // of its longer side, around what is drawn: half of a felt line, the barbs of an arrow
constexpr double kWorthIt = 0.98;  // of the width and the height: a part that large is the whole

Rect with_rim(double left, double top, double right, double bottom, double width, double height) {
    const double rim = kRim * std::max(right - left, bottom - top);
    left = std::max(0.0, left - rim) / width;
    top = std::max(0.0, top - rim) / height;
    right = std::min(width, right + rim) / width;
    bottom = std::min(height, bottom + rim) / height;
    const bool whole = right - left >= kWorthIt && bottom - top >= kWorthIt;
    return !(right > left) || !(bottom > top) || whole ? kWhole : Rect{left, top, right - left, bottom - top};
}

std::vector<int> edge_of(const Image& picture) {
    std::vector<int> edge;
    for (int x = 0; x < picture.width; ++x)
        for (const int y : {0, picture.height - 1}) edge.push_back(picture.row(y)[x]);
    for (int y = 0; y < picture.height; ++y)
        for (const int x : {0, picture.width - 1}) edge.push_back(picture.row(y)[x]);
    return edge;
}

void move(std::vector<Point>& points, double right, double down) {
    for (Point& p : points) p = {p.x + right, p.y + down};
}

Image cut_out(const Image& whole, const Rect& part) {
    const int left = std::clamp(static_cast<int>(std::lround(part.left * whole.width)), 0, whole.width - 1),
              top = std::clamp(static_cast<int>(std::lround(part.top * whole.height)), 0, whole.height - 1);
    const int width = std::clamp(static_cast<int>(std::lround(part.width * whole.width)), 1, whole.width - left),
              height = std::clamp(static_cast<int>(std::lround(part.height * whole.height)), 1, whole.height - top);
    Image cut = make_image(width, height, whole.channels, whole.mm_per_pixel, 0);
    for (int y = 0; y < height; ++y) std::copy_n(whole.row(top + y) + left * whole.channels, width * whole.channels, cut.row(y));
    return cut;
}

}  // namespace

Rect inked_part(const Image& picture) {
    // Grey levels from the ground, and pixels in a row that stand out: what is paler or less is a shade or noise of a camera.
    constexpr int kInk = 24, kFewPixels = 2;
    constexpr double kOneGround = 0.98;  // of the edge
    if (picture.channels != 1 || picture.width < 2 || picture.height < 2) return kWhole;
    std::vector<int> edge = edge_of(picture);
    const auto middle = edge.begin() + static_cast<std::ptrdiff_t>(edge.size() / 2);
    std::nth_element(edge.begin(), middle, edge.end());
    const int ground = *middle;
    const auto stands_out = [&](int level) { return std::abs(level - ground) > kInk; };
    if (static_cast<double>(std::count_if(edge.begin(), edge.end(), stands_out)) >
        (1 - kOneGround) * static_cast<double>(edge.size()))
        return kWhole;
    std::vector<int> in_row(static_cast<std::size_t>(picture.height)), in_column(static_cast<std::size_t>(picture.width));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (stands_out(picture.row(y)[x])) {
                ++in_row[static_cast<std::size_t>(y)];
                ++in_column[static_cast<std::size_t>(x)];
            }
    const auto is_inked = [](int count) { return count >= kFewPixels; };
    const auto span = [&](const std::vector<int>& counts) {
        const auto first = std::find_if(counts.begin(), counts.end(), is_inked);
        const auto last = std::find_if(counts.rbegin(), counts.rend(), is_inked);
        return std::pair(static_cast<double>(first - counts.begin()), static_cast<double>(counts.rend() - last));
    };
    const auto [left, right] = span(in_column);
    const auto [top, bottom] = span(in_row);
    return with_rim(left, top, right, bottom, picture.width, picture.height);
}

Rect inked_part(const FoundPage& figure) {
    Box box = kNothing;
    for (const PageStroke& stroke : figure.page.strokes)
        for (const Point& p : stroke.points) box.take(p);
    for (const auto* areas : {&figure.page.areas, &figure.page.textured})
        for (const Area& area : *areas)
            for (const auto& ring : area.rings)
                for (const Point& p : ring) box.take(p);
    for (const FoundPicture& picture : figure.pictures) {
        box.take({picture.shown.left, picture.shown.top});
        box.take({picture.shown.left + picture.shown.width, picture.shown.top + picture.shown.height});
    }
    return with_rim(box.left, box.top, box.right, box.bottom, figure.page.width, figure.page.height);
}

Drawing cut_out(Drawing whole, const Rect& part) {
    const double right = -part.left * whole.width, down = -part.top * whole.height;
    for (Stroke& stroke : whole.strokes) move(stroke.points, right, down);
    for (Area& area : whole.areas)
        for (auto& ring : area.rings) move(ring, right, down);
    for (Label& label : whole.labels) label.at = {label.at.x + right, label.at.y + down};
    for (Name& name : whole.names) name.at = {name.at.x + right, name.at.y + down};
    for (Region& region : whole.regions) {
        for (auto& ring : region.rings) move(ring, right, down);
        region.at = {region.at.x + right, region.at.y + down};
    }
    if (whole.picture) whole.picture = cut_out(*whole.picture, part);
    whole.width *= part.width;
    whole.height *= part.height;
    return whole;
}

}  // namespace tactics
