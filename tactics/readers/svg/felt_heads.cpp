// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/felt_heads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "tactics/geometry/course.h"
#include "tactics/geometry/grid.h"
#include "tactics/geometry/places.h"
#include "tactics/geometry/vectors.h"
#include "tactics/readers/svg/svg_marker.h"

namespace tactics {

namespace {

constexpr double kLeastSide = 6.4;    // mm, as of heads in pictures (filters/known_parts.cpp)
constexpr float kHeadStrength = 255;  // short as they are, other lines yield to them
constexpr double kLargestHead = 12;
// Degrees between a side and the line: at 30 a side ends 3.2 mm from the line, which would be cut short at less.
constexpr double kLeastAngle = 35, kMostAngle = 40;
constexpr double kOfLine = 0.8;      // of its line a head may cover
constexpr double kLastPart = 3;      // mm of a line that tell where it goes
constexpr double kTouches = 2;       // mm from a tip to the middle of the line that it touches: half a gap and a half line
constexpr double kStraightOn = 0.5;  // cosine of the angle in which that lies
constexpr std::size_t kMostHeads = 5'000;

// An end of an open line.
struct ShaftEnd {
    std::size_t stroke;
    Point at, way;  // of length 1, out of the line
    double length;  // of all of it
};

// Where a line is that far from its end.
Point inside(const std::vector<Point>& points, bool from_end, double far) {
    const auto at = [&](std::size_t i) { return from_end ? points[points.size() - 1 - i] : points[i]; };
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double step = distance(at(i - 1), at(i));
        if (step >= far && step > 0) {
            const double t = far / step;
            return {at(i - 1).x + t * (at(i).x - at(i - 1).x), at(i - 1).y + t * (at(i).y - at(i - 1).y)};
        }
        far -= step;
    }
    return at(points.size() - 1);
}

struct Head {
    Point tip, way;
    double length = 0, half = 0;  // half of its width
    const ShaftEnd* shaft = nullptr;
};

double side_of(const Head& head) { return std::hypot(head.length, head.half); }

// Without ways out and back: graphviz draws the end of the line with an open head.
std::vector<Point> without_spikes(const std::vector<Point>& ring, double same) {
    std::vector<Point> kept;
    for (const Point& p : ring) {
        if (!kept.empty() && distance(kept.back(), p) < same) continue;
        if (kept.size() > 1 && distance(kept[kept.size() - 2], p) < same)
            kept.pop_back();
        else
            kept.push_back(p);
    }
    while (kept.size() > 2 &&
           (distance(kept.back(), kept.front()) < same || distance(kept[kept.size() - 2], kept.front()) < same))
        kept.pop_back();
    return kept;
}

// A line of few corners or curves whose ends lie behind its tip on both sides: back, tip and back; nothing: it is none. TeX bows
// both sides towards the shaft; what is bowed the other way is an arc.
std::optional<std::array<Point, 3>> as_open_head(const std::vector<Point>& points) {
    constexpr std::size_t kMostOfHead = 80;
    constexpr double kBowed = 0.3;  // of a side
    if (points.size() < 3 || points.size() > kMostOfHead) return std::nullopt;
    const Point first = points.front(), last = points.back(), middle{(first.x + last.x) / 2, (first.y + last.y) / 2};
    const auto off = [&](Point p) { return std::abs(cross(last - first, p - first)); };
    const auto tip = std::max_element(points.begin(), points.end(), [&](Point a, Point b) { return off(a) < off(b); });
    if (tip == points.begin() || tip + 1 == points.end() || !(off(*tip) > 0)) return std::nullopt;
    const auto is_side = [&](auto begin, auto end, Point back) {
        const double length = distance(back, *tip);
        const double inwards = cross(*tip - back, middle - back) > 0 ? 1 : -1;
        return std::all_of(begin, end, [&](Point p) {
            const double bow = inwards * cross(*tip - back, p - back) / length;
            return bow > -length / 50 && bow < kBowed * length;
        });
    };
    if (!is_side(points.begin() + 1, tip, first) || !is_side(tip + 1, points.end() - 1, last)) return std::nullopt;
    return std::array{first, *tip, last};
}

class Heads {
public:
    explicit Heads(Drawing& drawing) : drawing_(drawing), ends_at_({0, 0, drawing.width, drawing.height}, kLargestHead / 4) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
            const Stroke& stroke = drawing.strokes[i];
            for (std::size_t k = 1; k < stroke.points.size() + (stroke.closed ? 1 : 0); ++k) {
                sides_.push_back({stroke.points[k - 1], stroke.points[k % stroke.points.size()], i});
                boxes.push_back(box_of({sides_.back().a, sides_.back().b}, 0));
            }
            if (!stroke.closed && (stroke.role == Role::line || stroke.role == Role::dash || stroke.role == Role::dots))
                add_ends(i);
        }
        grid_ = Grid(std::move(boxes), drawing.width, drawing.height);
    }

    void run() {
        std::vector<Stroke> opened;
        std::size_t count = 0;
        std::vector<std::optional<Head>> heads;
        Shapes others;
        for (const Area& area : drawing_.areas) {
            heads.push_back(may_be_filled(area) ? filled(area.rings[0]) : std::nullopt);
            if (may_be_filled(area) && !heads.back()) others.add(area.rings[0]);
        }
        for (std::size_t i = 0; i < heads.size(); ++i) {
            Area& area = drawing_.areas[i];
            if (!heads[i] || others.hold_several(area.rings[0]) || ++count > kMostHeads) continue;
            drop_rim(area.rings[0]);
            area.rings.clear();
            opened.emplace_back();
            make_felt(*heads[i], opened.back());
        }
        for (Stroke& stroke : drawing_.strokes)
            if (!stroke.closed && (stroke.role == Role::line || stroke.role == Role::arrow))
                if (const auto head = open(stroke); head && ++count <= kMostHeads) make_felt(*head, stroke);
        std::erase_if(drawing_.areas, [](const Area& area) { return area.rings.empty(); });
        std::move(opened.begin(), opened.end(), std::back_inserter(drawing_.strokes));
        std::erase_if(drawing_.strokes, [](const Stroke& stroke) { return stroke.points.empty(); });
    }

private:
    // Surfaces by their size: a triangle at the end of a curve of which there are others along it is a mark of a plot.
    class Shapes {
    public:
        void add(const std::vector<Point>& ring) { ++counts_[size_of_shape(ring)]; }
        bool hold_several(const std::vector<Point>& ring) const {
            constexpr std::size_t kSeveral = 2;
            const auto [wide, high] = size_of_shape(ring);
            std::size_t count = 0;
            for (const long x : {wide - 1, wide, wide + 1})
                for (const long y : {high - 1, high, high + 1})
                    if (const auto found = counts_.find({x, y}); found != counts_.end()) count += found->second;
            return count >= kSeveral;
        }

    private:
        static std::pair<long, long> size_of_shape(const std::vector<Point>& ring) {
            constexpr double kStep = 0.05;  // mm
            const Box box = tactics::box_of(ring);
            return {std::lround(box.width() / kStep), std::lround(box.height() / kStep)};
        }
        std::map<std::pair<long, long>, std::size_t> counts_;
    };

    static bool may_be_filled(const Area& area) {
        return area.texture == 0 && area.rings.size() == 1 && (area.role == Role::line || area.role == Role::arrow);
    }

    struct Side {
        Point a, b;
        std::size_t stroke;
    };

    void add_ends(std::size_t number) {
        const std::vector<Point>& points = drawing_.strokes[number].points;
        const double length = length_of(drawing_.strokes[number]);
        if (!(length > 0)) return;
        for (const bool from_end : {false, true}) {
            const Point at = from_end ? points.back() : points.front(), before = inside(points, from_end, kLastPart);
            const double far = distance(before, at);
            if (!(far > 0)) continue;
            ends_at_.add(at);
            ends_.push_back({number, at, {(at.x - before.x) / far, (at.y - before.y) / far}, length});
        }
    }

    // The head that these corners are at one of the ends around.
    std::optional<Head> head_of(const std::vector<Point>& all, Point middle, double extent, std::size_t but) const {
        constexpr double kAside = 0.3;  // of the half width
        std::optional<Head> best;
        ends_at_.any_near(middle, extent, [&](std::size_t i) {
            const ShaftEnd& end = ends_[i];
            if (end.stroke == but || distance(end.at, middle) > extent) return false;
            const auto along = [&](Point p) { return dot(p - end.at, end.way); };
            const auto aside = [&](Point p) { return cross(end.way, p - end.at); };
            const Point tip = *std::max_element(all.begin(), all.end(), [&](Point a, Point b) { return along(a) < along(b); });
            Head head{tip, end.way, 0, 0, &end};
            double left = 0, right = 0;
            for (const Point p : all) {
                head.length = std::max(head.length, along(tip) - along(p));
                left = std::min(left, aside(p));
                right = std::max(right, aside(p));
            }
            head.half = (right - left) / 2;
            const bool even = std::abs(left + right) < 2 * kAside * head.half && std::abs(aside(tip)) < kAside * head.half;
            if (even && head.half > 0 && head.length > head.half / 2 &&
                (!best || std::abs(aside(tip)) < std::abs(cross(best->way, best->tip - best->shaft->at))))
                best = head;
            return false;
        });
        return best;
    }

    std::optional<Head> filled(const std::vector<Point>& ring) const {
        const Box box = tactics::box_of(ring);
        const double extent = std::max(box.width(), box.height());
        if (!(extent > 0) || extent > kLargestHead) return std::nullopt;
        std::vector<Point> around = without_spikes(ring, extent / 50);
        if (around.empty()) return std::nullopt;
        around.push_back(around.front());
        std::vector<Point> all = course_of(around, extent / 10);
        all.pop_back();
        if (all.size() < 3 || !is_head(all)) return std::nullopt;
        return head_of(all, box.middle(), extent, drawing_.strokes.size());
    }

    void make_felt(const Head& head, Stroke& stroke) {
        const Point tip = touching(head);
        stroke.role = Role::arrow;
        stroke.strength = kHeadStrength;
        stroke.points = corners(head, tip);
        lead_to(tip, *head.shaft);
    }

    // The line of a head ends at its tip.
    void lead_to(Point tip, const ShaftEnd& end) {
        std::vector<Point>& points = drawing_.strokes[end.stroke].points;
        (distance(points.back(), end.at) <= distance(points.front(), end.at) ? points.back() : points.front()) = tip;
    }

    // The line around a head, which would make it blunt.
    void drop_rim(const std::vector<Point>& ring) {
        constexpr double kSameCorner = 0.2;  // mm
        grid_.any_near(box_of({ring.front(), ring.front()}, kSameCorner), [&](std::size_t i) {
            std::vector<Point>& rim = drawing_.strokes[sides_[i].stroke].points;
            const auto is_of_ring = [&](Point p) {
                return std::any_of(ring.begin(), ring.end(), [&](Point q) { return distance(p, q) < kSameCorner; });
            };
            if (rim.size() > 2 && std::all_of(rim.begin(), rim.end(), is_of_ring)) rim.clear();
            return false;
        });
    }

    std::optional<Head> open(const Stroke& stroke) const {
        const auto corners = as_open_head(stroke.points);
        if (!corners) return std::nullopt;
        const std::vector<Point> all(corners->begin(), corners->end());
        const double one = distance(all[0], all[1]), other = distance(all[2], all[1]), longer = std::max(one, other);
        constexpr double kEven = 0.7;
        if (longer > kLargestHead || std::min(one, other) < kEven * longer) return std::nullopt;
        auto head = head_of(all, all[1], longer, static_cast<std::size_t>(&stroke - drawing_.strokes.data()));
        if (head && distance(head->tip, all[1]) > 0) head.reset();  // it points back
        return head;
    }

    // From one end of its back over the tip to the other.
    static std::vector<Point> corners(const Head& head, Point tip) {
        const double turn = std::clamp(std::atan2(head.half, head.length) * 180 / std::numbers::pi, kLeastAngle, kMostAngle) *
                            std::numbers::pi / 180;
        const double line = std::max(0.0, head.shaft->length + dot(tip - head.shaft->at, head.way));
        double length = head.length, half = head.half;
        if (side_of(head) < kLeastSide) {
            length = std::max(length, std::min(kLeastSide * std::cos(turn), kOfLine * line));
            half = std::max(half, length * std::tan(turn));
        }
        const auto corner = [&](double aside) {
            return Point{tip.x - length * head.way.x - aside * head.way.y, tip.y - length * head.way.y + aside * head.way.x};
        };
        return {corner(half), tip, corner(-half)};
    }

    // What lies right before the tip.
    Point touching(const Head& head) const {
        Point to = head.tip;
        double least = kTouches;
        grid_.any_near(box_of({head.tip, head.tip}, kTouches), [&](std::size_t i) {
            const Side& side = sides_[i];
            if (side.stroke == head.shaft->stroke || drawing_.strokes[side.stroke].role == Role::arrow) return false;
            const Point at = nearest_on_segment(head.tip, side.a, side.b);
            const double far = distance(at, head.tip);
            if (far < least && dot(at - head.tip, head.way) > kStraightOn * far) {
                least = far;
                to = at;
            }
            return false;
        });
        return to;
    }

    Drawing& drawing_;
    Places ends_at_;
    std::vector<ShaftEnd> ends_;
    std::vector<Side> sides_;
    Grid grid_;
};

}  // namespace

void make_heads_felt(Drawing& drawing) {
    if (drawing.strokes.empty()) return;
    Heads(drawing).run();
}

}  // namespace tactics
