// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/close_sides.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tactics/geometry/vectors.h"
#include "tactics/solid/largest_first.h"

namespace tactics {

namespace {

constexpr double kSideBySide = 0.05;  // sine: 3 degrees
constexpr double kAcross = 0.1;       // cosine up to which a move does not leave the line that an end must stay on
constexpr double kLong = 3;           // times the least distance: a strip is as long; what is shorter is a shape of its own
constexpr double kSame = 1 - 1e-9;    // of a cosine
constexpr double kAsLong = 1e-3;      // of a length, up to which another is the same, however the file was written
constexpr double kFarthest = 1.5;     // times the least distance that an end may move in all
constexpr std::size_t kMostCloseSides = 3000;  // every pair is looked at; a page with more is for no finger

Point direction_of(const DrawnSide& side) {
    const double length = std::max(1e-300, distance(side.from, side.to));
    return {(side.to.x - side.from.x) / length, (side.to.y - side.from.y) / length};
}

struct Pair {
    double apart;
    std::size_t kept, moved;
};

// How far apart they are where they are beside each other; nothing if they are not, or cross.
std::optional<double> beside(const DrawnSide& line, const DrawnSide& other, double apart) {
    const Point along = direction_of(line);
    if (std::abs(cross(along, direction_of(other))) > kSideBySide) return std::nullopt;
    const double length = distance(line.from, line.to);
    double from = dot(along, other.from - line.from), end = dot(along, other.to - line.from);
    double off_from = cross(along, other.from - line.from), off_end = cross(along, other.to - line.from);
    if (from > end) {
        std::swap(from, end);
        std::swap(off_from, off_end);
    }
    const double first = std::max(from, 0.0), last = std::min(end, length);
    if (!(last - first >= kLong * apart)) return std::nullopt;
    const auto off = [&](double at) { return off_from + (off_end - off_from) * (at - from) / (end - from); };
    const double a = off(first), b = off(last);
    const bool crosses = a * b < 0 && std::min(std::abs(a), std::abs(b)) > kAsLong * apart;
    return crosses ? std::nullopt : std::optional(std::max(std::abs(a), std::abs(b)));
}

class Uniting {
public:
    Uniting(std::vector<DrawnSide>& sides, double touching, double apart)
        : sides_(sides), touching_(touching), apart_(apart), tied_(2 * sides.size()) {
        for (const DrawnSide& side : sides) before_.insert(before_.end(), {side.from, side.to});
    }

    std::size_t unite() {
        std::size_t moved = 0;
        for (const Pair& pair : pairs())
            if (move(pair.kept, pair.moved) || move(pair.moved, pair.kept)) ++moved;
        return moved;
    }

private:
    // The closest first. Of two the longer is kept, and one that is drawn whole rather than one that is dashed; of two as long
    // that one which fewer others are close to, so that they need not move, too; else the first.
    std::vector<Pair> pairs() const {
        std::vector<Pair> found;
        std::vector<std::size_t> close(sides_.size(), 0);
        std::vector<double> distances;
        for (std::size_t i = 0; i < sides_.size(); ++i)
            for (std::size_t j = i + 1; j < sides_.size(); ++j) {
                const bool first = weight(i) >= weight(j);
                const auto off = beside(sides_[first ? i : j], sides_[first ? j : i], apart_);
                if (!off || !(*off > 2 * touching_ && *off < apart_)) continue;
                found.push_back({*off, i, j});
                distances.push_back(*off);
                ++close[i];
                ++close[j];
            }
        make_alike(distances, 0, kAsLong * apart_);
        for (std::size_t i = 0; i < found.size(); ++i) {
            Pair& pair = found[i];
            pair.apart = distances[i];
            const double one = weight(pair.kept), two = weight(pair.moved);
            const bool as_long = std::abs(one - two) <= kAsLong * std::max(one, two);
            if (as_long ? close[pair.kept] > close[pair.moved] : one < two) std::swap(pair.kept, pair.moved);
        }
        std::stable_sort(found.begin(), found.end(), [](const Pair& a, const Pair& b) { return a.apart < b.apart; });
        return found;
    }

    double weight(std::size_t side) const {
        return distance(sides_[side].from, sides_[side].to) * (sides_[side].twice ? 0.5 : 1);
    }

    Point& end(std::size_t number) { return number % 2 == 0 ? sides_[number / 2].from : sides_[number / 2].to; }

    // All ends on a side, and on those that go straight on from it: if only a part moved, the line would have a kink.
    std::vector<std::size_t> ends_on(std::size_t side) {
        const DrawnSide& line = sides_[side];
        const Point along = direction_of(line);
        double first = 0, last = distance(line.from, line.to);
        const auto is_on = [&](std::size_t number) {
            const Point from = end(number) - line.from;
            const double at = dot(along, from);
            return at > first - 2 * touching_ && at < last + 2 * touching_ && std::abs(cross(along, from)) <= 2 * touching_;
        };
        for (bool more = true; more;) {
            more = false;
            for (std::size_t i = 0; i < sides_.size(); ++i) {
                if (!is_on(2 * i) && !is_on(2 * i + 1)) continue;
                const Point a = sides_[i].from - line.from, b = sides_[i].to - line.from;
                if (std::max(std::abs(cross(along, a)), std::abs(cross(along, b))) > 2 * touching_) continue;
                const double least = std::min(dot(along, a), dot(along, b)), most = std::max(dot(along, a), dot(along, b));
                more = more || least < first - touching_ || most > last + touching_;
                first = std::min(first, least);
                last = std::max(last, most);
            }
        }
        std::vector<std::size_t> found;
        for (std::size_t number = 0; number < 2 * sides_.size(); ++number)
            if (is_on(number)) found.push_back(number);
        return found;
    }

    bool move(std::size_t kept, std::size_t moved) {
        const DrawnSide line = sides_[kept];
        const auto off = beside(line, sides_[moved], apart_);  // others have moved since
        if (!off || !(*off > 2 * touching_ && *off < apart_)) return false;
        const Point along = direction_of(line), across{-along.y, along.x};
        const std::vector<std::size_t> ends = ends_on(moved);
        for (const std::size_t number : ends) {
            const double by = -cross(along, end(number) - line.from);
            if (std::abs(by) <= 2 * touching_) continue;
            const Point then{end(number).x + by * across.x, end(number).y + by * across.y};
            if (distance(then, before_[number]) > kFarthest * apart_) return false;
            // All that is tied in just this direction is on the line, and goes along.
            for (const Point& tie : tied_[number])
                if (const double same = std::abs(dot(tie, across)); same > kAcross && same < kSame) return false;
        }
        for (const std::size_t number : ends) {
            Point& at = end(number);
            const double by = -cross(along, at - line.from);
            at = {at.x + by * across.x, at.y + by * across.y};
            tied_[number].push_back(across);
        }
        for (const std::size_t number : ends_on(kept)) tied_[number].push_back(across);
        return true;
    }

    std::vector<DrawnSide>& sides_;
    double touching_, apart_;
    std::vector<Point> before_;             // each end
    std::vector<std::vector<Point>> tied_;  // of each end, the normals of the lines that it must stay on
};

}  // namespace

std::size_t unite_close(std::vector<DrawnSide>& sides, double touching, double apart) {
    if (sides.size() > kMostCloseSides || !(apart > 2 * touching)) return 0;
    const std::size_t moved = Uniting(sides, touching, apart).unite();
    if (moved == 0) return 0;
    std::erase_if(sides, [&](const DrawnSide& side) { return !(distance(side.from, side.to) > touching); });
    sides = merged(sides, touching);
    return moved;
}

}  // namespace tactics
