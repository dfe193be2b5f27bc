// SPDX-License-Identifier: Apache-2.0
#include "filters/plot_symbols.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace tactics {

namespace {

// Corners on a circle, the first of them straight above its middle or turned by so much to the right.
std::vector<Point> ring(Point middle, double radius, int corners, double turned) {
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = turned + 2 * std::numbers::pi * i / corners;
        points.push_back({middle.x + radius * std::sin(angle), middle.y - radius * std::cos(angle)});
    }
    return points;
}

}  // namespace

double reach_of(PlotSymbol symbol, double radius) {
    constexpr double kSquare = 1.7, kTriangle = 1.7,
                     kCross = 1.5;  // of the disc's: sides of 6 and 7.4 mm where that is 5 mm across
    switch (symbol) {
        case PlotSymbol::square: return kSquare * radius;
        case PlotSymbol::triangle: return kTriangle * radius;
        case PlotSymbol::cross: return kCross * radius;
        case PlotSymbol::disc:
        case PlotSymbol::ring: break;
    }
    return radius;
}

void draw_symbol(PlotSymbol symbol, Point at, double radius, Drawing& drawing) {
    constexpr int kRound = 32;
    constexpr double kEighth = std::numbers::pi / 4;
    const double reach = reach_of(symbol, radius);
    const auto outline = [&](std::vector<Point> points, bool closed) {
        drawing.strokes.push_back({std::move(points), closed, LineClass::thin, 0, Role::symbol});
    };
    switch (symbol) {
        case PlotSymbol::disc:
        case PlotSymbol::triangle: drawing.areas.push_back(symbol_area(symbol, at, radius)); break;
        case PlotSymbol::ring: outline(ring(at, reach, kRound, 0), true); break;
        case PlotSymbol::square: outline(ring(at, reach, 4, kEighth), true); break;
        case PlotSymbol::cross: {
            const std::vector<Point> corners = ring(at, reach, 4, kEighth);
            outline({corners[0], corners[2]}, false);
            outline({corners[1], corners[3]}, false);
            break;
        }
    }
}

Area symbol_area(PlotSymbol symbol, Point at, double radius) {
    constexpr int kRound = 32;
    constexpr double kEighth = std::numbers::pi / 4, kLine = 0.7;
    const double reach = reach_of(symbol, radius);
    switch (symbol) {
        case PlotSymbol::ring: return {{ring(at, reach, kRound, 0), ring(at, reach - kLine, kRound, 0)}, Role::symbol};
        case PlotSymbol::square:
            return {{ring(at, reach, 4, kEighth), ring(at, reach - kLine * std::numbers::sqrt2, 4, kEighth)}, Role::symbol};
        case PlotSymbol::cross: {
            // From the notch between two arms out along the next one and back in.
            const std::vector<Point> notches = ring(at, kLine / std::numbers::sqrt2, 4, 0), ends = ring(at, reach, 4, kEighth);
            std::vector<Point> outline;
            for (std::size_t i = 0; i < 4; ++i) {
                const Point notch = notches[i], next = notches[(i + 1) % 4], end = ends[i];
                const Point across{(next.x - notch.x) / 2, (next.y - notch.y) / 2};
                outline.insert(outline.end(),
                               {notch, {end.x - across.x, end.y - across.y}, {end.x + across.x, end.y + across.y}});
            }
            return {{outline}, Role::symbol};
        }
        case PlotSymbol::triangle: return {{ring(at, reach, 3, 0)}, Role::symbol};
        case PlotSymbol::disc: break;
    }
    return {{ring(at, reach, kRound, 0)}, Role::symbol};
}

}  // namespace tactics
