// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/moved_off.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/geometry/convex.h"
#include "tactics/geometry/vectors.h"
#include "tactics/solid/layout.h"
#include "tactics/solid/parted.h"
#include "tactics/solid/space_box.h"

namespace tactics {

namespace {

constexpr double kMoreUnder = 0.5;          // of its area: what is more on or under another than beside it stays there
constexpr double kWhollyOn = 0.9;           // of its area
constexpr double kPartlyOn = 0.01;          // of its area: less is beside it
constexpr double kSameArea = 1e-3;          // of two areas, by which they may differ and be the same
constexpr std::size_t kFootCorners = 24;    // of a foot: a circle is right to 1 % of its radius
constexpr std::size_t kMostTogether = 400;  // things on one; more would be smaller than a finger
constexpr double kRowOf = 0.1;              // of the lower one's height that two things beside each other have in common

constexpr std::uint32_t kNoFoot = 0xffffffff;

// What a thing covers in the plane of the view, and how near it comes to the reader.
struct Foot {
    std::vector<std::uint32_t> parts;
    Convex hull;
    Box box = kNothing;
    double area = 0, low = 0, high = 0;
    std::uint32_t on = kNoFoot;  // what it stands on, lies in or is under
    bool covered = false;        // that hides it
    Point by{};                  // how far it moves on that
};

Convex few_corners(Convex hull) {
    if (hull.size() <= kFootCorners) return hull;
    std::vector<Point> extreme;
    for (std::size_t i = 0; i < kFootCorners; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kFootCorners;
        const Point way{std::cos(angle), std::sin(angle)};
        extreme.push_back(
            *std::max_element(hull.begin(), hull.end(), [&](Point a, Point b) { return dot(a, way) < dot(b, way); }));
    }
    return hull_of(std::move(extreme));
}

// Across which it is narrowest.
double width_of(const Convex& hull) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point side = hull[(i + 1) % hull.size()] - hull[i];
        const double length = std::hypot(side.x, side.y);
        if (!(length > 0)) continue;
        const Point out{side.y / length, -side.x / length};
        least = std::min(least, reach_of(hull, out) + reach_of(hull, {-out.x, -out.y}));
    }
    return std::isfinite(least) ? least : 0;
}

class MovingOff {
public:
    MovingOff(const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing, const ViewPlane& view, double gap)
        : parts_(parts), view_(view), gap_(gap), touching_(touching_in(parts)) {
        constexpr double kLooksDown = 0.7;  // cosine
        if (std::abs(view.toward.z) < kLooksDown) along_ = {1, 0};
        add_feet(thing);
        find_holders();
    }

    std::vector<Point3> moves() {
        std::vector<std::vector<std::uint32_t>> on(feet_.size() + 1);  // the last: on nothing
        for (std::uint32_t i = 0; i < feet_.size(); ++i) on[feet_[i].on == kNoFoot ? feet_.size() : feet_[i].on].push_back(i);
        // What stands on something moves by what that leaves of the bound.
        std::vector<std::size_t> holders = {feet_.size()};
        for (std::size_t next = 0; next < holders.size(); ++next) {
            const std::vector<std::uint32_t>& all = on[holders[next]];
            if (all.size() <= kMostTogether) part_all(all, holders[next] == feet_.size() ? nullptr : &feet_[holders[next]]);
            holders.insert(holders.end(), all.begin(), all.end());
        }
        std::vector<Point3> by;
        bool moved = false;
        for (std::uint32_t part = 0; part < parts_.size(); ++part) {
            const Point sum = moved_in_all(&feet_[foot_of_[part]]);
            moved = moved || std::hypot(sum.x, sum.y) > touching_;
            by.push_back(sum.x * view_.right + sum.y * view_.down);
        }
        return moved ? by : std::vector<Point3>{};
    }

private:
    void add_feet(const std::vector<std::uint32_t>& thing) {
        foot_of_.assign(parts_.size(), kNoFoot);
        const std::vector<char> loose = loose_objects(thing);
        // Of a thing, and of what is loose on it.
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
        for (std::uint32_t part = 0; part < parts_.size(); ++part) {
            const std::uint32_t alone = loose[part] != 0 ? parts_[part].object + 1 : 0;
            const auto [place, fresh] = numbers.try_emplace({thing[part], alone}, static_cast<std::uint32_t>(feet_.size()));
            if (fresh) feet_.emplace_back();
            feet_[place->second].parts.push_back(part);
            foot_of_[part] = place->second;
        }
        for (Foot& foot : feet_) measure(foot);
    }

    // The parts of objects that stand on another object of the same thing, under nothing: a plate that the file has as a part of
    // its table. What is thin and upright may be a wall of it.
    std::vector<char> loose_objects(const std::vector<std::uint32_t>& thing) const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, Foot> of;
        for (std::uint32_t part = 0; part < parts_.size(); ++part) of[{thing[part], parts_[part].object}].parts.push_back(part);
        for (auto& [whose, foot] : of) measure(foot);
        std::vector<char> loose(parts_.size(), 0);
        for (auto one = of.begin(); one != of.end(); ++one) {
            const Foot& foot = one->second;
            const bool is_thin = std::any_of(foot.parts.begin(), foot.parts.end(), [&](std::uint32_t part) {
                const ModelPart& one = parts_[part];
                return one.form == PartForm::line ||
                       (one.form == PartForm::face && std::abs(dot(one.box.axis[2], view_.toward)) < kAligned);
            });
            if (is_thin) continue;
            bool stands = false, is_under = false;
            for (auto other = of.lower_bound({one->first.first, 0}); other != of.end() && other->first.first == one->first.first;
                 ++other) {
                if (other == one || !meet(foot.box, other->second.box)) continue;
                const double share = shared(foot, other->second);
                stands = stands || (share > kWhollyOn && foot.area < other->second.area && rests_on(foot, other->second));
                is_under = is_under || (share > kPartlyOn && (rests_on(other->second, foot) || is_covered(foot, other->second)));
            }
            if (stands && !is_under)
                for (const std::uint32_t part : foot.parts) loose[part] = 1;
        }
        return loose;
    }

    void measure(Foot& foot) const {
        std::vector<Point> points;
        foot.low = std::numeric_limits<double>::infinity();
        foot.high = -foot.low;
        for (const std::uint32_t part : foot.parts) {
            for (const Patch& patch : parts_[part].solid.patches)
                for (const auto& ring : patch.rings)
                    for (const Point3& at : ring) points.push_back({dot(at, view_.right), dot(at, view_.down)});
            const Stretch depth = stretch_of(parts_[part].solid, view_.toward);
            foot.low = std::min(foot.low, depth.low);
            foot.high = std::max(foot.high, depth.high);
        }
        foot.hull = few_corners(hull_of(std::move(points)));
        foot.box = box_of(foot.hull);
        foot.area = area_of(foot.hull);
    }

    // Of the smaller one.
    double shared(const Foot& small, const Foot& large) const {
        if (small.area > touching_ * touching_) return area_of(common_part(small.hull, large.hull)) / small.area;
        return parting_of(small.hull, large.hull).room < -touching_ ? 1 : 0;
    }

    static bool is_same_area(const Foot& one, const Foot& other) {
        return std::abs(one.area - other.area) <= kSameArea * std::max(one.area, other.area);
    }

    bool rests_on(const Foot& upper, const Foot& lower) const {
        const double loose = kLoose * std::min(upper.high - upper.low, lower.high - lower.low) + touching_;
        return std::abs(upper.low - lower.high) <= loose;
    }

    void find_holders() {
        for (std::uint32_t i = 0; i < feet_.size(); ++i)
            for (std::uint32_t j = i + 1; j < feet_.size(); ++j) {
                if (!meet(feet_[i].box, feet_[j].box)) continue;
                const bool i_is_smaller =
                    is_same_area(feet_[i], feet_[j]) ? feet_[i].high > feet_[j].high : feet_[i].area < feet_[j].area;
                const std::uint32_t small = i_is_smaller ? i : j, large = i_is_smaller ? j : i;
                const double share = shared(feet_[small], feet_[large]);
                if (share >= kMoreUnder)
                    offer(small, large);
                else if (share > kPartlyOn && rests_on(feet_[i], feet_[j]))
                    offer(i, j);
                else if (share > kPartlyOn && rests_on(feet_[j], feet_[i]))
                    offer(j, i);
            }
        for (Foot& foot : feet_)  // what is under a table is held by the table, not by a tray on it
            while (foot.on != kNoFoot && feet_[foot.on].on != kNoFoot && foot.high <= feet_[foot.on].low + touching_)
                foot.on = feet_[foot.on].on;
        for (Foot& foot : feet_)
            if (foot.on != kNoFoot) foot.covered = is_covered(foot, feet_[foot.on]);
    }

    // The smallest holds it.
    void offer(std::uint32_t one, std::uint32_t holder) {
        if (feet_[one].on != kNoFoot && feet_[feet_[one].on].area <= (1 + kSameArea) * feet_[holder].area) return;
        for (std::uint32_t i = holder; i != kNoFoot; i = feet_[i].on)
            if (i == one) return;
        feet_[one].on = holder;
    }

    bool is_covered(const Foot& foot, const Foot& holder) const {
        const Point middle{(foot.box.left + foot.box.right) / 2, (foot.box.top + foot.box.bottom) / 2};
        const Point3 at = middle.x * view_.right + middle.y * view_.down;
        for (const std::uint32_t part : holder.parts)
            for (const Patch& patch : parts_[part].solid.patches) {
                const double facing = dot(patch.normal, view_.toward);
                if (std::abs(facing) < kLevel) continue;
                const double height = dot(patch.normal, patch.rings.front().front() - at) / facing;
                if (height > foot.high - touching_ && is_over(at + height * view_.toward, patch.normal, patch.rings)) return true;
            }
        return false;
    }

    // Flat, and nothing is lower.
    bool is_ground(const Foot* holder) const {
        if (holder == nullptr || along_.x != 0) return holder == nullptr;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Foot& foot : feet_) {
            low = std::min(low, foot.low);
            high = std::max(high, foot.high);
        }
        return holder->low <= low + kLoose * (high - low) &&
               std::all_of(holder->parts.begin(), holder->parts.end(), [&](auto part) {
                   return parts_[part].form == PartForm::face &&
                          std::abs(dot(parts_[part].box.axis[2], view_.toward)) >= kAligned;
               });
    }

    bool touch_in_space(const Foot& one, const Foot& other) const {
        const auto reach = [&](std::uint32_t part) { return kLoose * parts_[part].box.half[0]; };
        for (const std::uint32_t a : one.parts)
            for (const std::uint32_t b : other.parts)
                if (apart(space_of(parts_[a]), space_of(parts_[b])) <= std::min(reach(a), reach(b))) return true;
        return false;
    }

    // Beside each other where things move to the sides only.
    bool are_in_a_row(const Foot& one, const Foot& other) const {
        if (along_.x == 0) return true;
        const double common = std::min(one.box.bottom, other.box.bottom) - std::max(one.box.top, other.box.top);
        return common > kRowOf * std::min(one.box.height(), other.box.height());
    }

    Point moved_in_all(const Foot* foot) const {
        Point sum{};
        for (; foot != nullptr; foot = foot->on == kNoFoot ? nullptr : &feet_[foot->on])
            sum = {sum.x + foot->by.x, sum.y + foot->by.y};
        return sum;
    }

    // A place within the gap from the true one is the same to a finger, which does not tell less; and what has moved by no more
    // than half of its width still lies over the middle of where it was, and has passed nothing that was beside it.
    double most_for(const Foot& foot, double left) const {
        if (foot.covered) return 0;
        const double width = along_.x != 0 ? foot.box.width() : width_of(foot.hull);
        return std::max(0.0, std::min(left, width / 2));
    }

    // All of one holder. Things that are hidden or belong together are not parted.
    void part_all(const std::vector<std::uint32_t>& all, const Foot* holder) {
        if (all.empty()) return;
        const bool on_ground = is_ground(holder);
        const Point before = moved_in_all(holder);
        const double left = gap_ - std::hypot(before.x, before.y);
        std::vector<PartedShape> shapes;
        std::vector<std::array<std::uint32_t, 2>> pairs;
        std::vector<char> stays(all.size(), 0);
        for (std::uint32_t i = 0; i < all.size(); ++i) {
            const Foot& one = feet_[all[i]];
            shapes.push_back({one.hull, most_for(one, left)});
            for (std::uint32_t j = 0; j < i; ++j) {
                const Foot& other = feet_[all[j]];
                if (one.covered || other.covered || !meet(tactics::grown(one.box, 3 * gap_), other.box)) continue;
                if (!are_in_a_row(one, other)) continue;
                if (on_ground && touch_in_space(one, other)) {  // both stay, or a third would push one into the other
                    stays[i] = stays[j] = 1;
                    continue;
                }
                pairs.push_back({j, i});
            }
        }
        for (std::size_t i = 0; i < all.size(); ++i)
            if (stays[i] != 0) shapes[i].most = 0;
        const std::vector<Point> by =
            parted(shapes, pairs, holder == nullptr ? nullptr : &holder->hull, {gap_, touching_, along_.x != 0});
        for (std::size_t i = 0; i < all.size(); ++i) feet_[all[i]].by = by[i];
    }

    const std::vector<ModelPart>& parts_;
    const ViewPlane& view_;
    double gap_, touching_;
    Point along_{};  // the only way to move; zero: any
    std::vector<Foot> feet_;
    std::vector<std::uint32_t> foot_of_;  // of each part
};

}  // namespace

std::vector<Point3> moved_off(const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing, const ViewPlane& view,
                              double gap) {
    constexpr std::size_t kMostMoved = 2000;  // parts, of which every pair is looked at
    if (!(gap > 0) || parts.size() < 2 || parts.size() > kMostMoved) return {};
    return MovingOff(parts, thing, view, gap).moves();
}

}  // namespace tactics
