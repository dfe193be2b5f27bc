// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/own_course.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "tactics/layout/own_marks.h"
#include "tactics/readers/svg/svg_path.h"

namespace tactics {

namespace {

// "1234 567 -8 9": steps of a hundredth of a millimetre, each point from the one before it.
std::vector<Point> points_told(std::string_view text) {
    constexpr long kMost = 100'000'000;
    std::vector<Point> points;
    long x = 0, y = 0;
    const auto take = [&](long& place) {
        while (text.starts_with(' ')) text.remove_prefix(1);
        long by = 0;
        const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), by);
        if (fault != std::errc() || by < -kMost || by > kMost) return false;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        place += by;
        return place >= -kMost && place <= kMost;
    };
    while (!text.empty()) {
        if (!take(x) || !take(y)) return {};
        points.push_back({static_cast<double>(x) / 100, static_cast<double>(y) / 100});
    }
    return points;
}

std::vector<double> lengths_along(const std::vector<Point>& line) {
    std::vector<double> along{0};
    for (std::size_t i = 1; i < line.size(); ++i) along.push_back(along.back() + distance(line[i - 1], line[i]));
    return along;
}

Point place_at(const std::vector<Point>& line, const std::vector<double>& along, double share, std::size_t& piece) {
    const double wanted = share * along.back();
    while (piece + 2 < line.size() && along[piece + 1] < wanted) ++piece;
    const double length = along[piece + 1] - along[piece];
    const double t = length > 0 ? std::clamp((wanted - along[piece]) / length, 0.0, 1.0) : 0;
    return {line[piece].x + t * (line[piece + 1].x - line[piece].x), line[piece].y + t * (line[piece + 1].y - line[piece].y)};
}

}  // namespace

bool run_alike(const std::vector<Point>& a, const std::vector<Point>& b, double farthest) {
    if (a.size() < 2 || b.size() < 2) return false;
    const std::vector<double> of_a = lengths_along(a), of_b = lengths_along(b);
    if (!std::isfinite(of_a.back()) || !std::isfinite(of_b.back())) return false;
    std::vector<double> shares;
    for (const auto* along : {&of_a, &of_b})
        for (const double at : *along) shares.push_back(along->back() > 0 ? at / along->back() : 0);
    std::sort(shares.begin(), shares.end());
    std::size_t in_a = 0, in_b = 0;
    return std::all_of(shares.begin(), shares.end(), [&](double share) {
        return distance(place_at(a, of_a, share, in_a), place_at(b, of_b, share, in_b)) <= farthest;
    });
}

// Letters of a path; longer ones, which we do not write, count as drawn.
constexpr std::size_t kLongestPath = 256 * 1024;

std::optional<std::vector<Point>> course_told(const FoundMark& mark, const PageStroke& drawn) {
    const std::string_view path = mark.element->attribute(marks::kPath), told = mark.element->attribute(marks::kPoints);
    if (path.empty() || told.empty() || path.size() > kLongestPath) return std::nullopt;
    Pen pen(mark.transform);
    draw_path(path, pen);
    std::vector<Subpath> was = pen.finish();
    if (was.size() != 1 || was[0].closed != drawn.closed) return std::nullopt;
    // Some programs move a line by its points.
    const Point first = was[0].points.front(), now = drawn.points.front();
    Point moved{now.x - first.x, now.y - first.y};
    if (std::hypot(moved.x, moved.y) < kUnmoved) moved = {};
    for (Point& p : was[0].points) p = {p.x + moved.x, p.y + moved.y};
    if (!run_alike(was[0].points, drawn.points, kUnmoved)) return std::nullopt;
    std::vector<Point> points = points_told(told);
    if (points.size() < 2 || (drawn.closed && points.size() < 3)) return std::nullopt;
    for (Point& p : points) {
        p = mark.transform(p);
        p = {p.x + moved.x, p.y + moved.y};
    }
    return points;
}

}  // namespace tactics
