// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/moved_off.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/geometry/convex.h"
#include "tactics/geometry/vectors.h"
#include "tactics/solid/layout.h"
#include "tactics/solid/space_box.h"

namespace tactics {

namespace {

constexpr double kMoreUnder = 0.5;          // of its area: what is more on or under another than beside it stays there
constexpr double kWhollyOn = 0.9;           // of its area
constexpr std::size_t kFootCorners = 24;    // of a foot: a circle is right to 1 % of its radius
constexpr std::size_t kMostTogether = 400;  // things on one; more would be smaller than a finger
constexpr int kMostSteps = 200;
constexpr double kNearly = 0.15;    // of the gap, by which it may be too small without a need to move anything
constexpr double kEnough = 0.01;    // of the gap, by which one may be too small
constexpr double kLeastGap = 0.25;  // of the gap: where there is no room even for that, all stays as it is
constexpr double kRowOf = 0.1;      // of the lower one's height that two things beside each other have in common

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

void shift(Foot& foot, Point by) {
    for (Point& at : foot.hull) at = {at.x + by.x, at.y + by.y};
    foot.box = box_of(foot.hull);
    foot.by = {foot.by.x + by.x, foot.by.y + by.y};
}

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

// Two that might come too close.
struct FootPair {
    std::uint32_t one, other;
    Point way;    // from the one to the other
    double room;  // mm that they must have at least
};

// The least room that a thing must have to a side of what it stands on.
struct FootBorder {
    Point out;  // of length 1
    double at = 0, least = 0;
};

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
        for (std::size_t holder = 0; holder < on.size(); ++holder)
            if (on[holder].size() <= kMostTogether) part_all(on[holder], holder == feet_.size() ? nullptr : &feet_[holder]);
        std::vector<Point3> by;
        bool moved = false;
        for (std::uint32_t part = 0; part < parts_.size(); ++part) {
            Point sum{};
            for (std::uint32_t i = foot_of_[part]; i != kNoFoot; i = feet_[i].on)
                sum = {sum.x + feet_[i].by.x, sum.y + feet_[i].by.y};
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
                is_under = is_under || (share > 0 && (rests_on(other->second, foot) || is_covered(foot, other->second)));
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

    bool rests_on(const Foot& upper, const Foot& lower) const {
        const double loose = kLoose * std::min(upper.high - upper.low, lower.high - lower.low) + touching_;
        return std::abs(upper.low - lower.high) <= loose;
    }

    void find_holders() {
        for (std::uint32_t i = 0; i < feet_.size(); ++i)
            for (std::uint32_t j = i + 1; j < feet_.size(); ++j) {
                if (!meet(feet_[i].box, feet_[j].box)) continue;
                const bool i_is_smaller =
                    feet_[i].area != feet_[j].area ? feet_[i].area < feet_[j].area : feet_[i].high > feet_[j].high;
                const std::uint32_t small = i_is_smaller ? i : j, large = i_is_smaller ? j : i;
                const double share = shared(feet_[small], feet_[large]);
                if (share >= kMoreUnder)
                    offer(small, large);
                else if (share > 0 && rests_on(feet_[i], feet_[j]))
                    offer(i, j);
                else if (share > 0 && rests_on(feet_[j], feet_[i]))
                    offer(j, i);
            }
        for (Foot& foot : feet_)
            if (foot.on != kNoFoot) foot.covered = is_covered(foot, feet_[foot.on]);
    }

    // The smallest holds it.
    void offer(std::uint32_t one, std::uint32_t holder) {
        if (feet_[one].on != kNoFoot && feet_[feet_[one].on].area <= feet_[holder].area) return;
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

    // Those that might come too close; things that are hidden or belong together are not parted.
    std::vector<FootPair> neighbours(const std::vector<std::uint32_t>& all, bool on_ground) const {
        std::vector<FootPair> pairs;
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t j = i + 1; j < all.size(); ++j) {
                const Foot &one = feet_[all[i]], &other = feet_[all[j]];
                if (one.covered || other.covered || !are_in_a_row(one, other)) continue;
                if (on_ground && meet(tactics::grown(one.box, gap_), other.box) && touch_in_space(one, other)) continue;
                const Parting parting = parting_of(one.hull, other.hull, along_);
                // What is nearly apart stays so.
                const bool nearly = parting.room >= (1 - kNearly) * gap_ && parting.room < gap_;
                pairs.push_back({all[i], all[j], parting.way, nearly ? parting.room : gap_});
            }
        return pairs;
    }

    std::vector<FootBorder> borders_of(const Foot& foot, const Foot* holder) const {
        std::vector<FootBorder> borders;
        if (holder == nullptr || foot.covered) return borders;
        const Convex& ring = holder->hull;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point side = ring[(i + 1) % ring.size()] - ring[i];
            const double length = std::hypot(side.x, side.y);
            if (!(length > 0)) continue;
            const Point out{side.y / length, -side.x / length}, in{-out.x, -out.y};
            if (along_.x != 0 && std::abs(out.x) < 0.5) continue;
            const double at = reach_of(ring, out), room = at - reach_of(foot.hull, out);
            const double slack = room + reach_of(ring, in) - reach_of(foot.hull, in);
            // What is on the border, or over it, goes no farther out.
            const double least = room <= touching_              ? room
                                 : room >= (1 - kNearly) * gap_ ? std::min(gap_, room)
                                                                : std::min(gap_, std::max(slack, 0.0) / 2);
            borders.push_back({out, at, least});
        }
        return borders;
    }

    double part_once(const std::vector<FootPair>& pairs, double share_of_gap) {
        double worst = 0;
        for (const FootPair& pair : pairs) {
            Foot &one = feet_[pair.one], &other = feet_[pair.other];
            const double gap = std::min(pair.room, share_of_gap * gap_);
            if (!meet(tactics::grown(one.box, gap), other.box)) continue;
            const Parting parting = parting_of(one.hull, other.hull, along_);
            const double lack = gap - parting.room;
            if (lack <= kEnough * gap_) continue;
            worst = std::max(worst, lack);
            // The larger moves less.
            const double whole = one.area + other.area, share = whole > 0 ? other.area / whole : 0.5;
            shift(one, {-share * lack * parting.way.x, -share * lack * parting.way.y});
            shift(other, {(1 - share) * lack * parting.way.x, (1 - share) * lack * parting.way.y});
        }
        return worst;
    }

    double keep_on(std::uint32_t number, const std::vector<FootBorder>& borders, double share) {
        double worst = 0;
        for (const FootBorder& border : borders) {
            const double least = border.least > 0 ? share * border.least : border.least;
            const double lack = reach_of(feet_[number].hull, border.out) - border.at + least;
            if (lack <= kEnough * gap_) continue;
            worst = std::max(worst, lack);
            const double by = along_.x != 0 ? lack / std::abs(border.out.x) : lack;
            shift(feet_[number], {-by * border.out.x, along_.x != 0 ? 0 : -by * border.out.y});
        }
        return worst;
    }

    // All of one holder.
    void part_all(const std::vector<std::uint32_t>& all, const Foot* holder) {
        const auto pairs = neighbours(all, is_ground(holder));
        std::vector<std::vector<FootBorder>> borders;
        std::vector<Foot> before;
        for (const std::uint32_t one : all) {
            borders.push_back(borders_of(feet_[one], holder));
            before.push_back(feet_[one]);
        }
        for (double share = 1; share >= kLeastGap; share /= 2) {
            double worst = 0;
            for (int step = 0; step < kMostSteps; ++step) {
                worst = part_once(pairs, share);
                for (std::size_t i = 0; i < all.size(); ++i) worst = std::max(worst, keep_on(all[i], borders[i], share));
                if (worst == 0) break;
            }
            if (worst <= 2 * kEnough * gap_ && sides_kept(pairs)) return;
            for (std::size_t i = 0; i < all.size(); ++i) feet_[all[i]] = before[i];
        }
    }

    bool sides_kept(const std::vector<FootPair>& pairs) const {
        return std::none_of(pairs.begin(), pairs.end(), [&](const FootPair& pair) {
            const Box &one = feet_[pair.one].box, &other = feet_[pair.other].box;
            const Point between{other.left + other.right - one.left - one.right, other.top + other.bottom - one.top - one.bottom};
            return dot(between, pair.way) < -touching_;
        });
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
