// SPDX-License-Identifier: Apache-2.0
// What a row of dashes looks like.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "filters/dash_rows.h"

namespace tactics {

std::optional<bool> is_level(const DashRow& row) {
    const double across = std::abs(row.points.front().x - row.points.back().x),
                 down = std::abs(row.points.front().y - row.points.back().y);
    for (const Point& p : row.points)
        if (std::min(std::abs(p.x - row.points.front().x), std::abs(p.y - row.points.front().y)) > row.width) return std::nullopt;
    return across > down;
}

bool is_straight(const DashRow& row) {
    constexpr double kLonger = 2, kStraight = 0.985;
    double way = 0;
    for (std::size_t i = 1; i < row.points.size(); ++i) way += distance(row.points[i - 1], row.points[i]);
    for (std::size_t i = 0; i < row.points.size(); i += 2)
        if (distance(row.points[i], row.points[i + 1]) < kLonger * row.width) return false;
    return distance(row.points.front(), row.points.back()) >= kStraight * way;
}

DashLengths lengths_of(const DashRow& row) {
    std::vector<double> marks, steps;
    for (std::size_t i = 0; i < row.points.size(); i += 2) {
        marks.push_back(distance(row.points[i], row.points[i + 1]) + row.width);  // of their middle lines, with their ends
        if (i > 0) steps.push_back(distance(row.points[i - 2], row.points[i]));
    }
    const double mark = middle_length(marks);
    return {mark, std::max(0.0, middle_length(steps) - mark)};
}

double middle_length(std::vector<double> lengths) {
    const auto half = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), half, lengths.end());
    return *half;
}

bool is_dense(const DashRow& row) {
    constexpr std::size_t kMany = 6;                               // marks
    constexpr double kMostGap = 2.2, kUneven = 0.15, kEven = 0.7;  // of a mark; of the step from one to the next; of the steps
    if (row.points.size() < 2 * kMany) return false;
    // Dots and dashes take turns.
    const std::size_t turn = row.kind == DashKind::dashes_and_dots ? 4 : 2;
    std::vector<double> steps;
    for (std::size_t i = turn; i < row.points.size(); i += 2) steps.push_back(distance(row.points[i - turn], row.points[i]));
    const double step = middle_length(steps);
    const auto even =
        std::count_if(steps.begin(), steps.end(), [&](double one) { return std::abs(one - step) < kUneven * step; });
    const DashLengths usual = lengths_of(row);
    return usual.gap <= kMostGap * std::max(usual.mark, turn > 2 ? row.longest : 0) &&
           static_cast<double>(even) >= kEven * static_cast<double>(steps.size());
}

DashKind dash_kind(std::vector<double> lengths) {
    constexpr double kDot = 2.1;          // widths
    constexpr double kFarLonger = 1.8;    // a dash than the mark beside it
    constexpr double kLeastOfBoth = 0.2;  // share of the marks
    if (lengths.empty()) return DashKind::dashes;
    std::sort(lengths.begin(), lengths.end());
    // Few dots of dots are longer: two that are one piece of ink.
    const double few = lengths[lengths.size() * 17 / 20];
    if (few < kDot) return DashKind::dots;
    const auto longer = std::find_if(lengths.begin(), lengths.end(), [&](double length) { return length > few / kFarLonger; });
    const double shorts = static_cast<double>(longer - lengths.begin()) / static_cast<double>(lengths.size());
    return shorts >= kLeastOfBoth ? DashKind::dashes_and_dots : DashKind::dashes;
}

}  // namespace tactics
