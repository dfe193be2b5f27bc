// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/revolution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "tactics/geometry/course.h"
#include "tactics/solid/axis.h"
#include "tactics/solid/joined_sides.h"

namespace tactics {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kLeastFacets = 10;  // round an axis; with fewer it is not round
constexpr int kCuts = 32;                 // half-planes round the axis
constexpr double kAlike = 0.8;            // of them that have the same profile; the others have a handle
constexpr double kOffRadius = 0.055;      // of a radius: a decagon's sides are 4.9 % nearer to its middle than its corners
constexpr double kOffSize = 0.012;        // of the size, as a finger feels at 10 cm
constexpr double kWholeSide = 0.107;      // of the area round an axis that may look one way: more than a tenth, less than a ninth
constexpr double kEnd = 0.02;             // of the height, within which a profile ends
constexpr double kFlat = 0.0175;  // slope up to which an end is flat: 1 degree; of a dome it is more wherever a course bends
constexpr double kLast = 1e-4;    // of the size, as near to the end as to be at it
constexpr double kHollow = 0.3;   // of the height, deeper than which a dent is a hollow

double distance_to(const std::vector<ProfileLine>& profile, Point at) {
    double least = std::numeric_limits<double>::infinity();
    for (const ProfileLine& line : profile) {
        const std::size_t n = line.points.size(), sides = line.closed ? n : n - 1;
        for (std::size_t i = 0; i < sides; ++i)
            least = std::min(least, distance_to_segment(at, line.points[i], line.points[(i + 1) % n]));
    }
    return least;
}

double length_of(const std::vector<DrawnSide>& sides) {
    double sum = 0;
    for (const DrawnSide& side : sides) sum += distance(side.from, side.to);
    return sum;
}

// A solid in the frame of an axis: x and y across it, z along it.
class Turned {
public:
    Turned(const Solid& solid, const SpaceLine& axis) : axis_(axis) {
        u_ = unit(std::abs(axis.along.z) < 0.9 ? cross({0, 0, 1}, axis.along) : cross({1, 0, 0}, axis.along));
        v_ = cross(axis.along, u_);
        for (const Patch& patch : solid.patches) {
            Flat& flat = patches_.emplace_back();
            flat.normal = local(patch.normal);
            flat.area = patch.area;
            for (const auto& ring : patch.rings) {
                flat.rings.emplace_back();
                for (const Point3& at : ring) {
                    flat.rings.back().push_back(local(at - axis.at));
                    const Point3& own = flat.rings.back().back();
                    low_ = std::min(low_, own.z);
                    high_ = std::max(high_, own.z);
                    widest_ = std::max(widest_, std::hypot(own.x, own.y));
                }
            }
        }
    }

    std::optional<Revolution> found() {
        if (!(high_ > low_) || !(widest_ > 0) || !looks_all_ways()) return std::nullopt;
        size_ = std::max(high_ - low_, widest_);
        std::array<std::vector<DrawnSide>, kCuts> cuts;
        std::vector<std::pair<double, int>> by_length;
        for (int i = 0; i < kCuts; ++i) {
            cuts[static_cast<std::size_t>(i)] = cut(angle_of(i));
            by_length.emplace_back(length_of(cuts[static_cast<std::size_t>(i)]), i);
        }
        std::sort(by_length.begin(), by_length.end());
        const int middle = by_length[kCuts / 2].second;
        profile_ = lines_of(cuts[static_cast<std::size_t>(middle)]);
        if (profile_.empty()) return std::nullopt;
        const double whole = by_length[kCuts / 2].first;
        const auto alike = std::count_if(cuts.begin(), cuts.end(), [&](const auto& one) { return is_alike(one, whole); });
        if (static_cast<double>(alike) < kAlike * kCuts) return std::nullopt;
        return made();
    }

private:
    struct Flat {
        Point3 normal;
        double area = 0;
        std::vector<std::vector<Point3>> rings;
    };

    Point3 local(const Point3& at) const { return {dot(at, u_), dot(at, v_), dot(at, axis_.along)}; }
    static double angle_of(int cut) { return 2 * kPi * (cut + 0.377) / kCuts; }  // none that a file would have its corners at
    double tolerance(Point at) const { return kOffRadius * at.x + kOffSize * size_; }

    // No way that its sides look in has as much area as each of the nine of a prism of nine sides.
    bool looks_all_ways() const {
        constexpr int kBins = 720;
        std::array<double, kBins> bins{};
        double all = 0, side = 0;
        for (const Flat& flat : patches_) {
            all += flat.area;
            const double across = std::hypot(flat.normal.x, flat.normal.y);
            if (across < 0.2) continue;
            const double turn = std::atan2(flat.normal.y, flat.normal.x) / (2 * kPi);
            bins[static_cast<std::size_t>(std::floor((turn + 1) * kBins)) % kBins] += flat.area;
            side += flat.area;
        }
        if (side < 0.05 * all) return false;
        for (std::size_t i = 0; i < kBins; ++i)
            if (bins[i] + bins[(i + 1) % kBins] + bins[(i + 2) % kBins] > kWholeSide * side) return false;
        return true;
    }

    // What a half-plane at that angle cuts out, x from the axis and y along it.
    std::vector<DrawnSide> cut(double angle) const {
        const Point out{std::cos(angle), std::sin(angle)};
        std::vector<DrawnSide> sides;
        for (const Flat& flat : patches_) {
            std::vector<Point> crossings;
            for (const auto& ring : flat.rings)
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    const Point3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
                    const double off_a = out.x * a.y - out.y * a.x, off_b = out.x * b.y - out.y * b.x;
                    if ((off_a >= 0) == (off_b >= 0)) continue;
                    const double share = off_a / (off_a - off_b);
                    const Point3 at = a + share * (b - a);
                    crossings.push_back({out.x * at.x + out.y * at.y, at.z});
                }
            // Along the line in which the patch and the plane meet.
            const double across = out.x * flat.normal.x + out.y * flat.normal.y;
            std::sort(crossings.begin(), crossings.end(),
                      [&](Point a, Point b) { return flat.normal.z * a.x - across * a.y < flat.normal.z * b.x - across * b.y; });
            for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
                Point a = crossings[i], b = crossings[i + 1];
                if (a.x > b.x) std::swap(a, b);
                if (!(b.x > 0)) continue;
                if (a.x < 0) a = {0, a.y + (b.y - a.y) * (0 - a.x) / (b.x - a.x)};
                sides.push_back({a, b});
            }
        }
        return sides;
    }

    std::vector<ProfileLine> lines_of(const std::vector<DrawnSide>& sides) const {
        const double touching = 1e-4 * size_;
        std::vector<DrawnSide> felt = sides;
        std::erase_if(felt, [&](const DrawnSide& side) { return !(distance(side.from, side.to) > touching); });
        std::vector<ProfileLine> lines;
        for (Stroke& stroke : joined(felt, touching)) {
            ProfileLine& line = lines.emplace_back();
            line.closed = stroke.closed;
            if (line.closed) stroke.points.push_back(stroke.points.front());
            line.points = course_of(stroke.points, 0.001 * size_);
            if (line.closed) line.points.pop_back();
            if (line.points.size() < 2) lines.pop_back();
        }
        return lines;
    }

    // Both ways: nothing that the profile has not, nor less.
    bool is_alike(const std::vector<DrawnSide>& sides, double whole) const {
        if (std::abs(length_of(sides) - whole) > 0.15 * whole) return false;
        const double step = size_ / 24;
        for (const DrawnSide& side : sides) {
            const int steps = static_cast<int>(std::ceil(distance(side.from, side.to) / step));
            for (int i = 0; i <= steps; ++i) {
                const double share = steps > 0 ? static_cast<double>(i) / steps : 0;
                const Point at{side.from.x + share * (side.to.x - side.from.x), side.from.y + share * (side.to.y - side.from.y)};
                if (distance_to(profile_, at) > tolerance(at)) return false;
            }
        }
        return true;
    }

    // The corners of facets lie on the surface, their middles within it.
    void widen(std::vector<ProfileLine>& profile) const {
        for (ProfileLine& line : profile)
            for (Point& at : line.points) {
                if (at.x < 1e-3 * size_) {
                    at.x = 0;
                    continue;
                }
                double most = at.x;
                for (const Flat& flat : patches_)
                    for (const auto& ring : flat.rings)
                        for (const Point3& corner : ring) {
                            if (std::abs(corner.z - at.y) > 0.003 * size_) continue;
                            const double radius = std::hypot(corner.x, corner.y);
                            if (radius < at.x * (1 + kOffRadius)) most = std::max(most, radius);
                        }
                at.x = most;
            }
    }

    // What lies farther from the profile than its facets do.
    Point handle() const {
        std::vector<Point> off;
        double farthest = 0;
        Point first{};
        for (const Flat& flat : patches_)
            for (const auto& ring : flat.rings)
                for (const Point3& corner : ring) {
                    const Point at{std::hypot(corner.x, corner.y), corner.z};
                    if (distance_to(profile_, at) <= 2 * tolerance(at)) continue;
                    off.push_back({corner.x, corner.y});
                    if (at.x > farthest * (1 + 1e-3)) {
                        farthest = at.x;
                        first = off.back();
                    }
                }
        Point sum{};
        for (const Point& one : off)
            if (one.x * first.x + one.y * first.y > 0.85 * farthest * std::hypot(one.x, one.y))
                sum = {sum.x + one.x, sum.y + one.y};
        const double length = std::hypot(sum.x, sum.y);
        return length > 0 ? Point{sum.x / length, sum.y / length} : Point{};
    }

    Revolution::End end_of(bool high) const;
    Primitive primitive() const;
    Revolution made();

    SpaceLine axis_;
    Point3 u_, v_;
    std::vector<Flat> patches_;
    double low_ = std::numeric_limits<double>::infinity(), high_ = -low_, widest_ = 0, size_ = 0;
    std::vector<ProfileLine> profile_;
};

// Where a line along the axis, at that distance from it, meets the profile last before an end.
double last_at(const std::vector<ProfileLine>& profile, double radius, double sign) {
    double most = -std::numeric_limits<double>::infinity();
    for (const ProfileLine& line : profile) {
        const std::size_t n = line.points.size(), sides = line.closed ? n : n - 1;
        for (std::size_t i = 0; i < sides; ++i) {
            const Point &a = line.points[i], &b = line.points[(i + 1) % n];
            if ((a.x > radius) == (b.x > radius)) continue;
            most = std::max(most, sign * (a.y + (radius - a.x) / (b.x - a.x) * (b.y - a.y)));
        }
    }
    return most;
}

Revolution::End Turned::end_of(bool high) const {
    const double sign = high ? 1 : -1, height = high_ - low_;
    double last = -std::numeric_limits<double>::infinity();
    for (const ProfileLine& line : profile_)
        for (const Point& at : line.points) last = std::max(last, sign * at.y);
    // It stands on what is flat, or on a ring round a dent; a round end has neither.
    double inner = std::numeric_limits<double>::infinity(), outer = 0;
    for (const ProfileLine& line : profile_)
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const Point &at = line.points[i], &next = line.points[(i + 1) % line.points.size()];
            if (sign * at.y < last - kEnd * height) continue;
            inner = std::min(inner, at.x);
            if (sign * at.y >= last - kLast * size_) outer = std::max(outer, at.x);
            if ((i + 1 < line.points.size() || line.closed) && sign * next.y >= last - kEnd * height &&
                std::abs(next.y - at.y) <= kFlat * std::abs(next.x - at.x))
                outer = std::max({outer, at.x, next.x});
        }
    double floor = -std::numeric_limits<double>::infinity();
    for (const double share : {0.03, 0.2, 0.5}) floor = std::max(floor, last_at(profile_, share * inner, sign));
    const bool open = inner > 0.05 * size_ && floor < last - kHollow * height;
    return {open ? inner : outer, open};
}

Primitive Turned::primitive() const {
    const double middle = (low_ + high_) / 2;
    bool cylinder = true, cone = true, sphere = std::abs((high_ - low_) / 2 - widest_) < 0.06 * widest_;
    const double height = high_ - low_;
    for (const ProfileLine& line : profile_) {
        const std::size_t n = line.points.size(), sides = line.closed ? n : n - 1;
        for (std::size_t i = 0; i < sides; ++i)
            for (const double share : {0.0, 0.5}) {
                const Point &a = line.points[i], &b = line.points[(i + 1) % n];
                const Point at{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
                const double up = (at.y - low_) / height, off = 0.03 * widest_;
                const bool ends = up < kEnd || up > 1 - kEnd;
                cylinder = cylinder && (ends || std::abs(at.x - widest_) < off);
                cone = cone && (up < kEnd || std::abs(at.x - widest_ * (1 - up)) < off);
                sphere = sphere && std::abs(std::hypot(at.x, at.y - middle) - widest_) < 2 * off;
            }
    }
    return sphere ? Primitive::sphere : cylinder ? Primitive::cylinder : cone ? Primitive::cone : Primitive::none;
}

Revolution Turned::made() {
    widen(profile_);
    const Point toward = handle();
    Revolution round;
    round.axis = axis_.along;
    round.foot = axis_.at + low_ * axis_.along;
    round.height = high_ - low_;
    widest_ = 0;
    for (const ProfileLine& line : profile_)
        for (const Point& at : line.points) widest_ = std::max(widest_, at.x);
    round.widest = widest_;
    round.low = end_of(false);
    round.high = end_of(true);
    if (toward.x != 0 || toward.y != 0) {
        round.handle = toward.x * u_ + toward.y * v_;
        round.handled = lines_of(cut(std::atan2(toward.y, toward.x) + 1e-3));
    } else {
        round.primitive = primitive();
    }
    round.profile = std::move(profile_);
    for (std::vector<ProfileLine>* lines : {&round.profile, &round.handled})
        for (ProfileLine& line : *lines)
            for (Point& at : line.points) at.y -= low_;
    return round;
}

}  // namespace

std::optional<Revolution> revolution_of(const Solid& solid) {
    if (solid.patches.size() < kLeastFacets) return std::nullopt;  // at once; found() sees which of them are round it
    std::optional<Revolution> round;
    any_axis(solid, [&](const SpaceLine& axis) {
        round = Turned(solid, axis).found();
        return round.has_value();
    });
    return round;
}

std::optional<Revolution> revolution_of(const Solid& solid, const Revolution& axis) {
    return Turned(solid, {axis.foot, axis.axis}).found();
}

Revolution revolution_of(Primitive primitive, const PrimitiveFrame& frame, bool has_low, bool has_high) {
    Revolution round;
    round.axis = unit(frame.c);
    round.height = 2 * length_of(frame.c);
    round.foot = frame.middle - frame.c;
    round.widest = length_of(frame.a);
    round.primitive = primitive;
    if (primitive == Primitive::sphere) return round;
    const bool cone = primitive == Primitive::cone;
    round.low = {round.widest, !has_low};
    round.high = {cone ? 0 : round.widest, !cone && !has_high};
    ProfileLine line;
    if (has_low) line.points.push_back({0, 0});
    line.points.push_back({round.widest, 0});
    line.points.push_back({cone ? 0 : round.widest, round.height});
    if (!cone && has_high) line.points.push_back({0, round.height});
    round.profile = {line};
    return round;
}

double reach_at(const std::vector<ProfileLine>& profile, double height) {
    double most = 0;
    for (const ProfileLine& line : profile) {
        const std::size_t n = line.points.size(), sides = line.closed ? n : n - 1;
        for (std::size_t i = 0; i < sides; ++i) {
            const Point &a = line.points[i], &b = line.points[(i + 1) % n];
            if (std::min(a.y, b.y) > height || std::max(a.y, b.y) < height) continue;
            const double share = a.y != b.y ? (height - a.y) / (b.y - a.y) : a.x > b.x ? 0 : 1;
            most = std::max(most, a.x + share * (b.x - a.x));
        }
    }
    return most;
}

}  // namespace tactics
