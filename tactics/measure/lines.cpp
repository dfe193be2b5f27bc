// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tactics/geometry/skeleton.h"

namespace tactics {

namespace {

constexpr float kAlways = std::numeric_limits<float>::max();
constexpr float kTiny = std::numeric_limits<float>::min();

std::size_t index_of(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

EdgeMap make_lines(int width, int height) {
    EdgeMap lines;
    lines.width = width;
    lines.height = height;
    lines.strength.assign(index_of(0, height, width), 0.0f);
    return lines;
}

// The column or row of a smaller map that lies under pixel `at` of `size` pixels.
int under(int at, int size, int smaller) { return static_cast<int>((2LL * at + 1) * smaller / (2LL * size)); }

void draw_edges(EdgeMap& lines, const EdgeMap& edges) {
    for (int y = 0; y < lines.height; ++y)
        for (int x = 0; x < lines.width; ++x)
            lines.strength[index_of(x, y, lines.width)] =
                edges.strength[index_of(under(x, lines.width, edges.width), under(y, lines.height, edges.height), edges.width)];
}

// A pixel is border if the next one to the right or below differs, so that a border is one pixel wide and lies on the same
// side of a step as in people's maps.
void draw_borders(EdgeMap& lines, const Image& image) {
    const auto at = [&](int x, int y) {
        return image.row(under(y, lines.height, image.height)) + under(x, lines.width, image.width) * image.channels;
    };
    for (int y = 0; y < lines.height; ++y)
        for (int x = 0; x < lines.width; ++x) {
            const int right = std::min(x + 1, lines.width - 1), below = std::min(y + 1, lines.height - 1);
            const std::uint8_t* here = at(x, y);
            const auto differs = [&](const std::uint8_t* there) { return !std::equal(here, here + image.channels, there); };
            if (differs(at(right, y)) || differs(at(x, below))) lines.strength[index_of(x, y, lines.width)] = kAlways;
        }
}

// Draws polylines given in mm, one pixel wide.
class Pen {
public:
    Pen(EdgeMap& lines, const Drawing& drawing)
        : lines_(lines), x_scale_(lines.width / drawing.width), y_scale_(lines.height / drawing.height) {}

    void draw(const std::vector<Point>& points, bool closed, float strength) {
        for (std::size_t i = 1; i < points.size(); ++i) side(points[i - 1], points[i], strength);
        if (closed && points.size() > 1) side(points.back(), points.front(), strength);
    }

private:
    void side(Point a, Point b, float strength) {
        a = {a.x * x_scale_, a.y * y_scale_};
        b = {b.x * x_scale_, b.y * y_scale_};
        const int steps = std::max(1, static_cast<int>(std::ceil(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)))));
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            dot(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), strength);
        }
    }

    void dot(double x, double y, float strength) {
        const int column = std::clamp(static_cast<int>(std::floor(x)), 0, lines_.width - 1);
        const int row = std::clamp(static_cast<int>(std::floor(y)), 0, lines_.height - 1);
        float& there = lines_.strength[index_of(column, row, lines_.width)];
        there = std::max(there, strength);
    }

    EdgeMap& lines_;
    double x_scale_, y_scale_;
};

void draw_drawing(EdgeMap& lines, const Drawing& drawing) {
    const bool graded =
        std::any_of(drawing.strokes.begin(), drawing.strokes.end(), [](const Stroke& stroke) { return stroke.strength > 0; });
    if (drawing.picture) draw_borders(lines, *drawing.picture);
    Pen pen(lines, drawing);
    for (const Stroke& stroke : drawing.strokes)
        pen.draw(stroke.points, stroke.closed, graded ? std::max(stroke.strength, kTiny) : kAlways);
    for (const Area& area : drawing.areas)
        for (const auto& ring : area.rings) pen.draw(ring, true, kAlways);
}

PixelSet thinned(InkMap ink) {
    PixelSet set{ink.width, ink.height, {}};
    const Skeleton skeleton = thin(std::move(ink));
    set.pixels.reserve(skeleton.pixels.size());
    for (const std::uint32_t pixel : skeleton.pixels)
        set.pixels.push_back(static_cast<std::uint32_t>(index_of(skeleton.x_of(pixel), skeleton.y_of(pixel), set.width)));
    return set;
}

}  // namespace

EdgeMap lines_of(const Artwork& artwork, int width, int height) {
    EdgeMap lines = make_lines(width, height);
    if (const auto* edges = std::get_if<EdgeMap>(&artwork)) draw_edges(lines, *edges);
    if (const auto* tree = std::get_if<RegionTree>(&artwork)) draw_edges(lines, levels_of(*tree));
    if (const auto* image = std::get_if<Image>(&artwork)) draw_borders(lines, *image);
    if (const auto* drawing = std::get_if<Drawing>(&artwork)) draw_drawing(lines, *drawing);
    return lines;
}

PixelSet cut_at(const EdgeMap& lines, float level) {
    InkMap ink(lines.width, lines.height);
    const float least = std::max(level, kTiny);
    for (int y = 0; y < lines.height; ++y) {
        const float* from = lines.strength.data() + index_of(0, y, lines.width);
        std::uint8_t* to = ink.row(y);
        for (int x = 0; x < lines.width; ++x) to[x] = from[x] >= least;
    }
    return thinned(std::move(ink));
}

PixelSet thinned(const PixelSet& set) {
    InkMap ink(set.width, set.height);
    for (const std::uint32_t pixel : set.pixels)
        ink.row(static_cast<int>(pixel / static_cast<std::uint32_t>(set.width)))[pixel % static_cast<std::uint32_t>(set.width)] =
            1;
    return thinned(std::move(ink));
}

}  // namespace tactics
