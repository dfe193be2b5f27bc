// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/trimmed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "filters/components.h"
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

template <typename Take>
void each_on_edge(const Image& picture, Take take) {
    for (int x = 0; x < picture.width; ++x)
        for (const int y : {0, picture.height - 1}) take(picture.row(y) + x * picture.channels);
    for (int y = 0; y < picture.height; ++y)
        for (const int x : {0, picture.width - 1}) take(picture.row(y) + x * picture.channels);
}

// The middle level of each channel on the edge.
std::array<int, 3> ground_of(const Image& picture) {
    std::array<int, 3> ground{};
    for (int channel = 0; channel < picture.channels; ++channel) {
        std::vector<int> edge;
        each_on_edge(picture, [&](const std::uint8_t* pixel) { edge.push_back(pixel[channel]); });
        const auto middle = edge.begin() + static_cast<std::ptrdiff_t>(edge.size() / 2);
        std::nth_element(edge.begin(), middle, edge.end());
        ground[static_cast<std::size_t>(channel)] = *middle;
    }
    return ground;
}

void move(std::vector<Point>& points, double right, double down) {
    for (Point& p : points) p = {p.x + right, p.y + down};
}

}  // namespace

Rect inked_part(const Image& picture) {
    // Levels from the ground, and the pixels that hang together at such: what is paler or smaller is noise or a speck. A pale
    // shade or a thin line is none, as recipes draw both.
    constexpr int kInk = 24, kPale = 6;
    constexpr std::size_t kInkPixels = 4, kPalePixels = 64;
    constexpr double kOneGround = 0.98;  // of the edge
    if (picture.channels > 3 || picture.width < 2 || picture.height < 2) return kWhole;
    const std::array<int, 3> ground = ground_of(picture);
    const auto off_ground = [&](const std::uint8_t* pixel) {
        int off = 0;
        for (int channel = 0; channel < picture.channels; ++channel)
            off = std::max(off, std::abs(pixel[channel] - ground[static_cast<std::size_t>(channel)]));
        return off;
    };
    double edge = 0, inked_edge = 0;
    each_on_edge(picture, [&](const std::uint8_t* pixel) {
        ++edge;
        if (off_ground(pixel) > kInk) ++inked_edge;
    });
    if (inked_edge > (1 - kOneGround) * edge) return kWhole;
    const auto width = static_cast<std::size_t>(picture.width);
    const Components pieces = find_components(picture.width, picture.height, Joined::by_corners, [&](std::size_t i) {
        return off_ground(picture.row(static_cast<int>(i / width)) + i % width * static_cast<std::size_t>(picture.channels)) >
               kPale;
    });
    const std::vector<std::size_t> areas = pieces.areas();
    std::vector<std::size_t> inked(pieces.count);
    for (const Run& run : pieces.runs)
        for (int x = run.begin; x < run.end; ++x)
            if (off_ground(picture.row(run.row) + x * picture.channels) > kInk) ++inked[run.component];
    Box box = kNothing;
    for (const Run& run : pieces.runs) {
        if (inked[run.component] < kInkPixels && areas[run.component] < kPalePixels) continue;
        box.take({static_cast<double>(run.begin), static_cast<double>(run.row)});
        box.take({static_cast<double>(run.end), static_cast<double>(run.row + 1)});
    }
    return with_rim(box.left, box.top, box.right, box.bottom, picture.width, picture.height);
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

Image cut_out(Image whole, const Rect& part) {
    if (part.width >= 1 && part.height >= 1) return whole;
    const int left = std::clamp(static_cast<int>(std::lround(part.left * whole.width)), 0, whole.width - 1),
              top = std::clamp(static_cast<int>(std::lround(part.top * whole.height)), 0, whole.height - 1);
    const int width = std::clamp(static_cast<int>(std::lround(part.width * whole.width)), 1, whole.width - left),
              height = std::clamp(static_cast<int>(std::lround(part.height * whole.height)), 1, whole.height - top);
    Image cut = make_image(width, height, whole.channels, whole.mm_per_pixel, 0);
    for (int y = 0; y < height; ++y) std::copy_n(whole.row(top + y) + left * whole.channels, width * whole.channels, cut.row(y));
    return cut;
}

Drawing cut_out(Drawing whole, const Rect& part) {
    if (part.width >= 1 && part.height >= 1) return whole;
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
    if (whole.picture) whole.picture = cut_out(std::move(*whole.picture), part);
    whole.width *= part.width;
    whole.height *= part.height;
    return whole;
}

}  // namespace tactics
