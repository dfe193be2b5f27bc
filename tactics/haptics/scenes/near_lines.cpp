// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/near_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tactics {

namespace {

constexpr double kCell = 1;  // mm: a few segments matter in each
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostCells = 4'000'000;

// The smooth minimum of two distances, and how it changes with each and with its width.
struct Minimum {
    double value, of_first, of_second, of_width;
};
Minimum smooth_minimum(double first, double second, double width) noexcept {
    const double apart = second - first;
    if (!(apart < width)) return {first, 1, 0, 0};
    const double share = 1 - apart / width;
    return {first - width * share * share / 4, 1 - share / 2, share / 2, -share * share / 4 - share * apart / (2 * width)};
}

Point away_from(Point place, Point from, double distance) noexcept {
    if (!(distance > 0)) return {};
    return {(place.x - from.x) / distance, (place.y - from.y) / distance};
}

// How wide the minimum of two feet is made, and how that changes with the rise of the line between them: it grows with it, one to
// one at first, up to `blend`, which it has at kFullRise of that.
constexpr double kFullRise = 2;
struct Width {
    double value, of_rise;
};
Width width_of(double rise, double blend) noexcept {
    const double share = std::clamp(rise / (kFullRise * blend), 0.0, 1.0);
    return {blend * share * (2 - share), 2 * (1 - share) / kFullRise};
}

// Segments by the cells that they pass, to find those round a place.
class Buckets {
public:
    Buckets(std::size_t columns, std::size_t rows) : columns_(columns), rows_(rows), cells_(columns * rows) {}
    void add(std::uint32_t segment, std::size_t left, std::size_t top, std::size_t right, std::size_t bottom) {
        for (std::size_t row = top; row <= bottom; ++row)
            for (std::size_t column = left; column <= right; ++column) cells_[row * columns_ + column].push_back(segment);
    }
    // Calls visit(segment) for those in cells exactly `ring` away. false: no such cell is there.
    template <typename Visit>
    bool ring(std::size_t column, std::size_t row, std::size_t ring, Visit visit) const {
        const auto c = static_cast<std::ptrdiff_t>(column), r = static_cast<std::ptrdiff_t>(row),
                   k = static_cast<std::ptrdiff_t>(ring);
        bool any = false;
        for (std::ptrdiff_t y = r - k; y <= r + k; ++y) {
            if (y < 0 || y >= static_cast<std::ptrdiff_t>(rows_)) continue;
            const std::ptrdiff_t step = y == r - k || y == r + k || k == 0 ? 1 : 2 * k;
            for (std::ptrdiff_t x = c - k; x <= c + k; x += step) {
                if (x < 0 || x >= static_cast<std::ptrdiff_t>(columns_)) continue;
                any = true;
                for (const std::uint32_t segment : cells_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)])
                    visit(segment);
            }
        }
        return any;
    }

private:
    std::size_t columns_, rows_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace

NearLines::NearLines(const std::vector<std::vector<Point>>& lines, const Reach& reach) : blend_(reach.blend), far_(reach.far) {
    for (std::size_t line = 0; line < lines.size(); ++line) {
        const auto& points = lines[line];
        const std::size_t first = segments_.size();
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const double length = distance(points[i], points[i + 1]);
            if (!(length > 0)) continue;  // a point twice
            segments_.push_back({points[i],
                                 {(points[i + 1].x - points[i].x) / length, (points[i + 1].y - points[i].y) / length},
                                 length,
                                 static_cast<std::uint32_t>(line),
                                 static_cast<std::uint32_t>(i),
                                 true});
        }
        if (segments_.size() > first) segments_.back().goes_on = false;
    }
    if (!segments_.empty()) sort_into_cells();
}

double NearLines::distance_to(const Segment& segment, Point place) const noexcept {
    const double x = place.x - segment.from.x, y = place.y - segment.from.y;
    const double along = std::clamp(x * segment.way.x + y * segment.way.y, 0.0, segment.length);
    const double off_x = x - along * segment.way.x, off_y = y - along * segment.way.y;
    return std::sqrt(off_x * off_x + off_y * off_y);
}

namespace {

template <typename Segment>
Point end_of(const Segment& s) noexcept {
    return {s.from.x + s.length * s.way.x, s.from.y + s.length * s.way.y};
}

}  // namespace

void NearLines::lay_cells() {
    Point low{kNever, kNever}, high{-kNever, -kNever};
    for (const Segment& segment : segments_)
        for (const Point p : {segment.from, end_of(segment)}) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    corner_ = {low.x - far_, low.y - far_};
    const auto cells_over = [&](double length) { return static_cast<std::size_t>((length + 2 * far_) / kCell) + 1; };
    columns_ = cells_over(high.x - low.x);
    rows_ = cells_over(high.y - low.y);
    if (columns_ * rows_ > kMostCells) throw std::logic_error("lines far larger than any device");
}

void NearLines::sort_into_cells() {
    lay_cells();
    const auto cell = [](double at, double corner, std::size_t count) {
        return std::min(static_cast<std::size_t>(std::max(0.0, (at - corner) / kCell)), count - 1);
    };
    Buckets buckets(columns_, rows_);
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
        const Point a = segments_[i].from, b = end_of(segments_[i]);
        buckets.add(i, cell(std::min(a.x, b.x), corner_.x, columns_), cell(std::min(a.y, b.y), corner_.y, rows_),
                    cell(std::max(a.x, b.x), corner_.x, columns_), cell(std::max(a.y, b.y), corner_.y, rows_));
    }
    const double half = kCell * std::sqrt(0.5);
    std::vector<Found> found;
    std::vector<std::uint32_t> seen(segments_.size(), UINT32_MAX);  // for which cell
    for (std::size_t row = 0; row < rows_; ++row)
        for (std::size_t column = 0; column < columns_; ++column) {
            const auto number = static_cast<std::uint32_t>(starts_.size());
            starts_.push_back(static_cast<std::uint32_t>(entries_.size()));
            const Point middle{corner_.x + (static_cast<double>(column) + 0.5) * kCell,
                               corner_.y + (static_cast<double>(row) + 0.5) * kCell};
            double nearest = kNever, second = kNever;
            found.clear();
            // What is `ring` cells away is at least ring - 1/2 of them from the middle.
            // A second foot lies within the blend, and what is left out of the line between two feet has its full rise.
            const auto wanted = [&] { return std::min(nearest + (kFullRise + 0.5) * blend_, second) + 2 * half; };
            for (std::size_t ring = 0;; ++ring) {
                const double there = (static_cast<double>(ring) - 0.5) * kCell;
                if (there > std::min(wanted(), far_ + (kFullRise + 0.5) * blend_ + 2 * half)) break;
                const auto look = [&](std::uint32_t segment) {
                    if (std::exchange(seen[segment], number) == number) return;
                    const double away = distance_to(segments_[segment], middle);
                    nearest = std::min(nearest, away);
                    if (away <= wanted()) found.push_back({segment, away});
                };
                if (!buckets.ring(column, row, ring, look)) break;
                second = std::min(second, second_foot(found, middle, half));
            }
            if (!(nearest - half < far_)) continue;
            const double most = wanted();
            const bool by_feet = second < nearest + (kFullRise + 0.5) * blend_;
            std::erase_if(found, [&](const Found& one) { return one.distance > most; });
            std::sort(found.begin(), found.end(),
                      [](const Found& one, const Found& other) { return one.segment < other.segment; });
            for (std::size_t i = 0; i < found.size(); ++i) {
                // Between two that hang together all is kept unless it goes so far away that no more of it would count.
                if (by_feet && i > 0 && !goes_far(found[i - 1].segment, found[i].segment, middle, most + kFullRise * blend_))
                    for (std::uint32_t between = found[i - 1].segment + 1; between < found[i].segment; ++between)
                        entries_.push_back(between);
                entries_.push_back(found[i].segment);
            }
        }
    starts_.push_back(static_cast<std::uint32_t>(entries_.size()));
}

// Whether the line between two segments ends or has a vertex beyond `most`.
bool NearLines::goes_far(std::uint32_t first, std::uint32_t last, Point middle, double most) const noexcept {
    for (std::uint32_t i = first; i < last; ++i)
        if (!segments_[i].goes_on || distance(segments_[i + 1].from, middle) > most) return true;
    return false;
}

// How far the second foot is at most, of any place in the cell, less half of it: where a line goes away between two segments
// farther than both are, each has a foot. Infinite where that is not so of the nearest segment and another that was found.
double NearLines::second_foot(const std::vector<Found>& found, Point middle, double half) const noexcept {
    constexpr std::uint32_t kMostBetween = 8;
    if (found.empty()) return kNever;
    const auto nearer = [](const Found& one, const Found& other) { return one.distance < other.distance; };
    const Found first = *std::min_element(found.begin(), found.end(), nearer);
    double least = kNever;
    for (const Found& one : found) {
        if (one.distance >= least || one.segment == first.segment) continue;
        const std::uint32_t low = std::min(first.segment, one.segment), high = std::max(first.segment, one.segment);
        if (high - low <= kMostBetween && goes_far(low, high, middle, one.distance + 2 * half)) least = one.distance;
    }
    return least;
}

// Only the two nearest feet count. The line between the feet beside one that is dropped goes as far as it went on either side of
// it. `saddle` and `top` are those of the next foot.
void NearLines::drop_farthest(Foot* feet, std::size_t& count, double& saddle, Point& top) noexcept {
    Foot* farthest =
        std::max_element(feet, feet + count, [](const Foot& one, const Foot& other) { return one.distance < other.distance; });
    double& next_saddle = farthest + 1 == feet + count ? saddle : (farthest + 1)->saddle;
    Point& next_top = farthest + 1 == feet + count ? top : (farthest + 1)->top;
    if (farthest->saddle > next_saddle) {
        next_saddle = farthest->saddle;
        next_top = farthest->top;
    }
    std::copy(farthest + 1, feet + count, farthest);
    --count;
}

std::size_t NearLines::feet_at(Point place, Foot* feet) const noexcept {
    const double u = (place.x - corner_.x) / kCell, v = (place.y - corner_.y) / kCell;
    if (!(u >= 0 && v >= 0 && u < static_cast<double>(columns_) && v < static_cast<double>(rows_))) return 0;
    const std::size_t cell = static_cast<std::size_t>(v) * columns_ + static_cast<std::size_t>(u);
    std::size_t count = 0;
    double saddle = kNever, worst = kNever;  // the square of how far a foot may be
    Point top;
    bool hangs = false, comes_down = false;  // on the segment before; and the line came nearer up to its end
    for (std::uint32_t e = starts_[cell]; e < starts_[cell + 1]; ++e) {
        const std::uint32_t index = entries_[e];
        const Segment& s = segments_[index];
        hangs = hangs && e > starts_[cell] && entries_[e - 1] + 1 == index && segments_[index - 1].goes_on;
        const double x = place.x - s.from.x, y = place.y - s.from.y, along = x * s.way.x + y * s.way.y;
        const double at_begin = x * x + y * y;
        if (!hangs) {
            saddle = kNever;
            comes_down = index == 0 || !segments_[index - 1].goes_on;  // a line's end is nearer than what is beyond it
        } else if (at_begin > saddle || saddle == -kNever) {
            saddle = at_begin;
            top = s.from;
        }
        hangs = true;
        const bool is_end = !s.goes_on;
        double foot = -1;
        if (along <= 0) {
            if (comes_down) foot = 0;
            comes_down = false;
        } else if (along < s.length) {
            foot = along;
            comes_down = false;
        } else {
            comes_down = true;
            if (is_end) foot = s.length;
        }
        if (foot < 0) continue;
        const Point nearest{s.from.x + foot * s.way.x, s.from.y + foot * s.way.y};
        const double off_x = place.x - nearest.x, off_y = place.y - nearest.y, squared = off_x * off_x + off_y * off_y;
        if (squared >= worst) continue;  // the line goes on to the next as if there were no foot
        const double away = std::sqrt(squared);
        feet[count++] = {away, away_from(place, nearest, away), index, foot, saddle, top};
        saddle = -kNever;
        if (count > 2) drop_farthest(feet, count, saddle, top);
        if (count == 2) worst = std::pow(std::max(feet[0].distance, feet[1].distance), 2);
    }
    return count;
}

Nearness NearLines::blended(Point place, const Foot* feet, std::size_t count) const noexcept {
    std::size_t first = 0, second = count;
    for (std::size_t i = 1; i < count; ++i)
        if (feet[i].distance < feet[first].distance) first = i;
    for (std::size_t i = 0; i < count; ++i)
        if (i != first && (second == count || feet[i].distance < feet[second].distance)) second = i;
    const Foot& best = feet[first];
    const Segment& segment = segments_[best.segment];
    Nearness near{best.distance, {best.slope.x, best.slope.y, 0}, segment.line, segment.index, {}, true};
    near.place = {segment.from.x + best.along * segment.way.x, segment.from.y + best.along * segment.way.y};
    if (second == count) return near;
    const Foot& other = feet[second];
    // The highest that the line goes between the two.
    double saddle = -kNever;
    Point top;
    for (std::size_t i = std::min(first, second) + 1; i <= std::max(first, second); ++i)
        if (feet[i].saddle > saddle) {
            saddle = feet[i].saddle;
            top = feet[i].top;
        }
    saddle = std::sqrt(saddle);
    const Point mean{(best.slope.x + other.slope.x) / 2, (best.slope.y + other.slope.y) / 2};
    const Width width = width_of(saddle - (best.distance + other.distance) / 2, blend_);
    const Minimum least = smooth_minimum(best.distance, other.distance, width.value);
    const Point up = saddle < kNever ? away_from(place, top, saddle) : mean;
    const double turn = least.of_width * width.of_rise;
    near.distance = least.value;
    near.slope.x = least.of_first * best.slope.x + least.of_second * other.slope.x + turn * (up.x - mean.x);
    near.slope.y = least.of_first * best.slope.y + least.of_second * other.slope.y + turn * (up.y - mean.y);
    return near;
}

Nearness NearLines::at(const Point3& place) const noexcept {
    std::array<Foot, kMostFeet> feet;
    if (segments_.empty() || !(std::abs(place.z) < far_)) return {};
    const std::size_t count = feet_at({place.x, place.y}, feet.data());
    if (count == 0) return {};
    Nearness near = blended({place.x, place.y}, feet.data(), count);
    // In space the line is as far as the hypotenuse says. Where two lines cross, the blended distance is below 0: on the line.
    const double flat = std::max(0.0, near.distance), whole = std::sqrt(flat * flat + place.z * place.z);
    const double share = whole > 0 ? flat / whole : 0;
    near.slope = {share * near.slope.x, share * near.slope.y, whole > 0 ? place.z / whole : 0};
    near.distance = whole;
    return near;
}

}  // namespace tactics
