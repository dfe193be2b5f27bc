// SPDX-License-Identifier: Apache-2.0
// Pages for the rules: made by hand, and by chance.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics::tests {

inline Page blank_page(double width = 200, double height = 200) {
    Page page;
    page.width = width;
    page.height = height;
    page.live = {0, 0, width, height};
    page.braille_dot = 1.6;
    return page;
}

inline void add_line(Page& page, std::vector<Point> points, double width = 1, bool closed = false) {
    page.strokes.push_back({std::move(points), closed, width});
}

inline std::vector<Point> rectangle(double left, double top, double width, double height) {
    return {{left, top}, {left + width, top}, {left + width, top + height}, {left, top + height}};
}

inline std::vector<Point> circle(Point middle, double radius, int corners = 720) {
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        points.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
    }
    return points;
}

inline Findings findings_of(const Page& page, const std::string& rule, double limit) {
    const Demand demand{find_rule(rule), limit};
    return check_page(page, {&demand, 1})[0].findings;
}

inline Findings findings_of(const Page& page, const std::string& rule) {
    return findings_of(page, rule, find_rule(rule)->limit.fallback);
}

/// Numbers by chance, the same ones everywhere: distributions of the standard library differ between libraries.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double between(double least, double most) { return least + (most - least) * static_cast<double>(engine_()) / 4294967295.0; }
    std::size_t below(std::size_t count) { return engine_() % count; }

private:
    std::mt19937 engine_;
};

inline std::vector<Point> wandering_line(Dice& chance, Point from, std::size_t points, double step) {
    std::vector<Point> line{from};
    double way = chance.between(0, 2 * std::numbers::pi);
    while (line.size() < points) {
        way += chance.between(-1, 1);
        const double length = chance.between(0.2 * step, step);
        line.push_back({line.back().x + length * std::cos(way), line.back().y + length * std::sin(way)});
    }
    return line;
}

/// A ring that does not cross itself: round a middle, near and far.
inline std::vector<Point> starry_ring(Dice& chance, Point middle, double least, double most) {
    std::vector<Point> ring;
    const std::size_t corners = 3 + chance.below(12);
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners),
                     far = chance.between(least, most);
        ring.push_back({middle.x + far * std::cos(angle), middle.y + far * std::sin(angle)});
    }
    return ring;
}

}  // namespace tactics::tests
