// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/near_lines.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

constexpr double kSquare = 2;  // mm: few segments matter in each, and where hundreds do they are not kept too often
constexpr std::size_t kMostSquares = 1'000'000;

// Orders segments by distance in as many steps as there are segments, because a query need not know more: of each step it is told
// where it begins.
class InSteps {
public:
    template <typename Take>
    void order(const std::vector<FoundSegment>& found, Take take) {
        if (found.empty()) return;
        const auto [near, far] = std::minmax_element(
            found.begin(), found.end(), [](const FoundSegment& a, const FoundSegment& b) { return a.distance < b.distance; });
        const double least = near->distance, step = (far->distance - least) / static_cast<double>(found.size());
        const auto step_of = [&](const FoundSegment& one) {
            return step > 0 ? std::min(static_cast<std::size_t>((one.distance - least) / step), found.size() - 1) : 0;
        };
        ends_.assign(found.size() + 1, 0);
        for (const FoundSegment& one : found) ++ends_[step_of(one) + 1];
        for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
        ordered_.resize(found.size());
        for (const FoundSegment& one : found) {
            const std::size_t at = step_of(one);
            // A little less, as numbers are rounded.
            ordered_[ends_[at]++] = {one.segment, (least + static_cast<double>(at) * step) * (1 - 1e-6)};
        }
        for (const FoundSegment& one : ordered_) take(one);
    }

private:
    std::vector<std::size_t> ends_;
    std::vector<FoundSegment> ordered_;
};

}  // namespace

NearLines::NearLines(const std::vector<std::vector<Point>>& lines, double far) : segments_(segments_of(lines)), far_(far) {
    squares_ = squares_round(segments_, far_, kSquare, kMostSquares);
    spans_.resize(squares_.columns * squares_.rows);
    InSteps steps;
    const auto square = [&](std::size_t column, std::size_t row, double, const std::vector<FoundSegment>& found) {
        const std::size_t first = entries_.size();
        steps.order(found, [&](const FoundSegment& one) { entries_.push_back({one.segment, static_cast<float>(one.distance)}); });
        spans_[row * squares_.columns + column] = {first, entries_.size()};
    };
    SquareDescent(segments_, squares_, far_, true, square, [](std::size_t, std::size_t, std::size_t) { return true; }).run();
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
