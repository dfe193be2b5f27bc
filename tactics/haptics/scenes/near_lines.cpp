// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/near_lines.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

constexpr double kSquare = 2;  // mm: few segments matter in each, and where hundreds do they are not kept too often
constexpr std::size_t kMostSquares = 1'000'000;

float rounded_down(double value) noexcept {
    const auto narrow = static_cast<float>(value);
    return static_cast<double>(narrow) > value ? std::nextafter(narrow, 0.0f) : narrow;
}

}  // namespace

NearLines::NearLines(const std::vector<std::vector<Point>>& lines, double far) : segments_(segments_of(lines)), far_(far) {
    squares_ = squares_round(segments_, far_, kSquare, kMostSquares);
    spans_.resize(squares_.columns * squares_.rows);
    const auto square = [&](std::size_t column, std::size_t row, double, std::vector<FoundSegment>& found) {
        const std::size_t first = entries_.size();
        std::sort(found.begin(), found.end(), [](const FoundSegment& one, const FoundSegment& other) {
            return one.distance != other.distance ? one.distance < other.distance : one.segment < other.segment;
        });
        for (const FoundSegment& one : found) entries_.push_back({one.segment, rounded_down(one.distance)});
        spans_[row * squares_.columns + column] = {first, entries_.size()};
    };
    SquareDescent(segments_, squares_, far_, true, square).run();
}

Nearness NearLines::at(const Point3& place) const noexcept {
    Nearness near;
    const double column = (place.x - squares_.corner.x) / squares_.side, row = (place.y - squares_.corner.y) / squares_.side;
    if (!(column >= 0 && row >= 0 && column < static_cast<double>(squares_.columns) && row < static_cast<double>(squares_.rows) &&
          std::abs(place.z) < far_))
        return near;
    const Point at{place.x, place.y};
    const Span& span = spans_[static_cast<std::size_t>(row) * squares_.columns + static_cast<std::size_t>(column)];
    const double off = distance(at, squares_.middle(std::floor(column), std::floor(row)));
    double least = INFINITY, along = 0;
    std::uint32_t best = 0;
    for (std::size_t i = span.first; i < span.end; ++i) {
        const Entry& entry = entries_[i];
        if (static_cast<double>(entry.distance) - off > least) break;  // and so are all that follow
        const LineSegment& segment = segments_[entry.segment];
        const double here = nearest_along(segment, at), away = distance(at, place_on(segment, here));
        if (away > least || (away == least && entry.segment > best)) continue;
        least = away;
        along = here;
        best = entry.segment;
    }
    if (span.first == span.end) return near;
    const LineSegment& segment = segments_[best];
    near = {std::sqrt(least * least + place.z * place.z), segment.line, segment.index, place_on(segment, along), true};
    near.within = near.distance < far_;
    return near;
}

}  // namespace tactics
