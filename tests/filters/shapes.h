// SPDX-License-Identifier: Apache-2.0
// Pictures of known shapes, and the plain ways to measure drawings, for the tests of trace and of the stroke filters.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "filters/list.h"
#include "tactics/image.h"

namespace tactics::shapes {

inline Image blank(int width, int height, double mm = 1) { return make_image(width, height, 1, mm, 255); }

inline double to_segment(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Black where the middle of the pixel fulfils `inside`.
template <typename Inside>
void fill(Image& image, Inside inside) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (inside(Point{x + 0.5, y + 0.5})) image.row(y)[x] = 0;
}
inline void bar(Image& image, Point a, Point b, double width) {
    fill(image, [=](Point p) { return to_segment(p, a, b) <= width / 2; });
}
inline void ring(Image& image, Point centre, double radius, double width) {
    fill(image, [=](Point p) { return std::abs(std::hypot(p.x - centre.x, p.y - centre.y) - radius) <= width / 2; });
}
inline void disc(Image& image, Point centre, double radius) {
    fill(image, [=](Point p) { return std::hypot(p.x - centre.x, p.y - centre.y) <= radius; });
}

/// Blots of random sizes over a random ground; the same on every machine.
inline Image random_picture(int width, int height, std::uint32_t seed, unsigned share) {
    Image image = blank(width, height);
    std::mt19937 random(seed);
    for (auto& pixel : image.pixels) pixel = random() % 100 < share ? 0 : 255;
    for (int i = 0; i < 4; ++i) {
        const Point centre{static_cast<double>(random() % static_cast<unsigned>(width)),
                           static_cast<double>(random() % static_cast<unsigned>(height))};
        disc(image, centre, static_cast<double>(random() % 12));
    }
    return image;
}

inline Artwork run(std::string_view steps, Artwork artwork) {
    return tactics::run(parse_recipe(steps, "test", filters()), std::move(artwork));
}
inline Drawing drawn(std::string_view steps, Artwork artwork) { return std::get<Drawing>(run(steps, std::move(artwork))); }

inline Stroke line(std::vector<Point> points, float strength = 0, bool closed = false) {
    return Stroke{std::move(points), closed, LineClass::normal, strength};
}

/// Least distance from `p` to the stroke.
inline double to_stroke(Point p, const Stroke& stroke) {
    double least = 1e9;
    const std::size_t n = stroke.points.size();
    for (std::size_t i = 1; i < n + (stroke.closed ? 1 : 0); ++i)
        least = std::min(least, to_segment(p, stroke.points[i - 1], stroke.points[i % n]));
    return least;
}

/// Points at even steps along a stroke.
inline std::vector<Point> walk(const Stroke& stroke, double step) {
    std::vector<Point> points;
    const std::size_t n = stroke.points.size();
    for (std::size_t i = 1; i < n + (stroke.closed ? 1 : 0); ++i) {
        const Point a = stroke.points[i - 1], b = stroke.points[i % n];
        const int parts = std::max(1, static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y) / step)));
        for (int k = 0; k < parts; ++k) points.push_back({a.x + (b.x - a.x) * k / parts, a.y + (b.y - a.y) * k / parts});
    }
    if (!stroke.closed) points.push_back(stroke.points.back());
    return points;
}

/// Whether the even-odd rule puts `p` inside.
inline bool inside(const Area& area, Point p) {
    bool in = false;
    for (const auto& points : area.rings)
        for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
            const Point a = points[i], b = points[j];
            if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
        }
    return in;
}

}  // namespace tactics::shapes
