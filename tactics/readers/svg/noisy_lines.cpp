// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/noisy_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/geometry/ink_columns.h"

namespace tactics {

namespace {

constexpr double kColumn = 0.15;     // mm, as of a picture of 170 dpi; its line is three wide
constexpr double kLeastNoisy = 40;   // mm; as in pictures (filters/noisy_curves.cpp)
constexpr double kMostBack = 0.02;   // of its way, against its direction
constexpr double kMostNoisy = 2000;  // mm
constexpr std::size_t kFewestTurns = 24;

bool runs_one_way(const std::vector<Point>& line) {
    double right = 0, left = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double step = line[i].x - line[i - 1].x;
        (step > 0 ? right : left) += std::abs(step);
    }
    return std::min(right, left) <= kMostBack * std::max(right, left);
}

// Where it turns from up to down, and back.
std::size_t turns_in(const std::vector<Point>& line) {
    std::size_t turns = 0;
    for (std::size_t i = 2; i < line.size(); ++i)
        turns += (line[i].y - line[i - 1].y) * (line[i - 1].y - line[i - 2].y) < 0 ? 1 : 0;
    return turns;
}

// As a picture has it, from `box.left` on.
std::vector<InkColumn> columns_of(const std::vector<Point>& line, const Box& box) {
    struct Span {
        double top = std::numeric_limits<double>::max(), bottom = std::numeric_limits<double>::lowest();
    };
    std::vector<Span> spans(static_cast<std::size_t>(box.width() / kColumn) + 1);
    const auto take = [&](std::size_t column, double y) {
        spans[column].top = std::min(spans[column].top, y);
        spans[column].bottom = std::max(spans[column].bottom, y);
    };
    const auto column_at = [&](double x) {
        return std::min(spans.size() - 1, static_cast<std::size_t>((x - box.left) / kColumn));
    };
    for (std::size_t i = 1; i < line.size(); ++i) {
        const auto [from, to] = line[i - 1].x <= line[i].x ? std::pair(line[i - 1], line[i]) : std::pair(line[i], line[i - 1]);
        const std::size_t first = column_at(from.x), last = column_at(to.x);
        take(first, from.y);
        take(last, to.y);
        for (std::size_t column = first + 1; column <= last; ++column) {
            const double x = box.left + static_cast<double>(column) * kColumn;
            const double y = from.y + (to.y - from.y) * (x - from.x) / (to.x - from.x);
            take(column - 1, y);
            take(column, y);
        }
    }
    std::vector<InkColumn> columns;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        if (spans[i].top > spans[i].bottom) continue;
        const int top = static_cast<int>(std::floor((spans[i].top - box.top) / kColumn)) - 1,
                  bottom = static_cast<int>(std::floor((spans[i].bottom - box.top) / kColumn)) + 1;
        columns.push_back({static_cast<int>(i), top, bottom, bottom - top + 1});
    }
    return columns;
}

}  // namespace

std::optional<NoisyLine> noisy_line(const std::vector<Point>& line) {
    const Box box = box_of(line);
    if (!(box.width() >= kLeastNoisy) || !(box.width() <= kMostNoisy) || turns_in(line) < kFewestTurns || !runs_one_way(line))
        return std::nullopt;
    const std::vector<InkColumn> columns = columns_of(line, box);
    if (!is_noise(columns, kColumn)) return std::nullopt;
    const auto on_page = [&](Point p) { return Point{box.left + p.x * kColumn, box.top + p.y * kColumn}; };
    NoisyLine noisy;
    const std::vector<Point> course = followable(columns, kColumn);
    for (const Point& p : course) noisy.course.push_back(on_page(p));
    for (const auto& [foot, tip] : spikes_of(columns, course, kColumn)) noisy.spikes.push_back({on_page(foot), on_page(tip)});
    return noisy;
}

}  // namespace tactics
