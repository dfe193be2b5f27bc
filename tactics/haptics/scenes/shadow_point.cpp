// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/shadow_point.h"

#include <algorithm>

namespace tactics {

namespace {

constexpr double kStill = 1e-9;       // mm: a move as short is none
constexpr double kWithin = 1e-10;     // mm: a plane is kept to by that
constexpr double kAlike = 1 - 1e-13;  // cosine between normals that are one
constexpr double kMostStretch = 1.9;  // below 2, so that a move along its planes still ends nearer to the finger
constexpr int kMostLong = 8;          // moves in an update that may not
constexpr double kLeastStride = 1e-4;
constexpr double kRoll = 1.0 / 8;   // of the radius
constexpr double kGrains = 1;       // leaves that are looked around
constexpr double kLeastBall = 0.1;  // mm: a smaller one does not roll
constexpr double kTouches = 1e-9;   // mm
constexpr int kMostRolls = 30;      // then facets are met one by one
// mm, which changes the force of 1 N/mm by 0.1 mN: a move as short is left to the next tick once three quarters of the work are
// used up.
constexpr double kAlmostStill = 1e-4;

bool kept(std::span<const ShadowPoint::Touching> planes, const Point3& way) noexcept {
    return std::all_of(planes.begin(), planes.end(), [&](const ShadowPoint::Touching& plane) {
        return dot(plane.contact.normal, way) >= -plane.contact.gap - kWithin;
    });
}

}  // namespace

ShadowPoint::ShadowPoint(const MeshTree& tree, double radius, int tick_work) noexcept
    : tree_(&tree),
      tick_work_(tick_work),
      radius_(std::max(radius, kLeastFinger)),
      keep_(1e-6 + 0.02 * radius_),
      around_(kGrains * tree.grain()) {
    const Point3 low = tree.low(), high = tree.high();
    largest_ = 1e6 + 2 * std::max({std::abs(low.x), std::abs(low.y), std::abs(low.z), std::abs(high.x), std::abs(high.y),
                                   std::abs(high.z)});
}

void ShadowPoint::drop(std::size_t number) noexcept { touching_[number] = touching_[--count_]; }

// From where it is now. What it has left is let go.
void ShadowPoint::look_again() noexcept {
    for (std::size_t k = 0; k < count_;) {
        touching_[k].contact = contact_of(tree_->corners(touching_[k].facet), place_, radius_);
        if (touching_[k].contact.gap > keep_)
            drop(k);
        else
            ++k;
    }
}

void ShadowPoint::touch(std::uint32_t facet) noexcept {
    const Touching fresh{facet, contact_of(tree_->corners(facet), place_, radius_), 0};
    for (std::size_t k = 0; k < count_; ++k)
        if (dot(touching_[k].contact.normal, fresh.contact.normal) > kAlike) {
            if (twins_ < kMost) twin_[twins_++] = facet;
            return;
        }
    if (count_ == kMost) {
        const auto farthest = std::max_element(touching_.begin(), touching_.end(), [](const Touching& a, const Touching& b) {
            return a.contact.gap < b.contact.gap;
        });
        *farthest = fresh;
        return;
    }
    touching_[count_++] = fresh;
}

// The nearest place to the wish on the planes that are held, all of them, if they all push and no other is passed.
bool ShadowPoint::try_held(const Point3& wish, std::span<const std::size_t> held, Point3& way) noexcept {
    const auto normal = [&](std::size_t k) -> const Point3& { return touching_[held[k]].contact.normal; };
    const auto lack = [&](std::size_t k) { return -touching_[held[k]].contact.gap - dot(normal(k), wish); };
    std::array<double, 3> push{};
    if (held.size() == 1) {
        push[0] = lack(0);
    } else if (held.size() == 2) {
        // By differences, as normals beside a ball that lies on fine facets are almost alike.
        const Point3 turn = normal(1) - normal(0), across = cross(normal(0), normal(1));
        const double apart = dot(across, across), c_below_1 = dot(turn, turn) / 2;
        if (apart < 1e-12) return false;
        const double more =
            touching_[held[0]].contact.gap - touching_[held[1]].contact.gap - dot(turn, wish);  // lack(1) - lack(0)
        push[0] = (c_below_1 * lack(1) - more) / apart;
        push[1] = (c_below_1 * lack(0) + more) / apart;
    } else {
        // Of the place where three planes meet, by Cramer's rule.
        const Point3 across[3] = {cross(normal(1), normal(2)), cross(normal(2), normal(0)), cross(normal(0), normal(1))};
        const double volume = dot(normal(0), across[0]);
        if (std::abs(volume) < 1e-9) return false;
        const Point3 shift = (1 / volume) * (lack(0) * across[0] + lack(1) * across[1] + lack(2) * across[2]);
        for (std::size_t k = 0; k < 3; ++k) push[k] = dot(shift, across[k]) / volume;
    }
    Point3 moved = wish;
    for (std::size_t k = 0; k < held.size(); ++k) {
        if (!(push[k] > 0)) return false;
        moved = moved + push[k] * normal(k);
    }
    if (!kept({touching_.data(), count_}, moved)) return false;
    for (std::size_t k = 0; k < held.size(); ++k) touching_[held[k]].pressed = push[k];
    way = moved;
    return true;
}

bool ShadowPoint::allowed(const Point3& wish, Point3& way) noexcept {
    for (std::size_t k = 0; k < count_; ++k) touching_[k].pressed = 0;
    way = wish;
    if (kept({touching_.data(), count_}, wish)) return true;
    std::array<std::size_t, 3> held{};
    for (held[0] = 0; held[0] < count_; ++held[0])
        if (try_held(wish, std::span(held).first(1), way)) return true;
    for (held[0] = 0; held[0] < count_; ++held[0])
        for (held[1] = held[0] + 1; held[1] < count_; ++held[1])
            if (try_held(wish, std::span(held).first(2), way)) return true;
    for (held[0] = 0; held[0] < count_; ++held[0])
        for (held[1] = held[0] + 1; held[1] < count_; ++held[1])
            for (held[2] = held[1] + 1; held[2] < count_; ++held[2])
                if (try_held(wish, held, way)) return true;
    return false;
}

// The move along planes that are all but tangents of round edges and corners: as far as the finger's pull takes it on those.
Point3 ShadowPoint::stretched(const Point3& way) noexcept {
    Point3 along = way;
    std::array<const Touching*, 2> held{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < count_; ++k)
        if (touching_[k].pressed > 0) {
            if (count == 2) return way;
            held[count++] = &touching_[k];
        }
    if (count == 0) return way;
    const Point3& first = held[0]->contact.normal;
    along = along - dot(along, first) * first;
    if (count == 2) {
        const Point3 line = cross(first, held[1]->contact.normal);
        along = (dot(line, along) / dot(line, line)) * line;
    }
    // Along an edge nothing is round; a line between two facets has one direction only.
    if (count == 1 && held[0]->contact.feature == FacetFeature::edge)
        along = along - dot(held[0]->contact.axis, along) * held[0]->contact.axis;
    const double squared = dot(along, along);
    if (squared < kStill * kStill) return way;
    double bend = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const FacetContact& contact = held[k]->contact;
        if (contact.feature == FacetFeature::face) continue;
        const double on_axis = contact.feature == FacetFeature::edge ? dot(contact.axis, along) : 0;
        bend += held[k]->pressed * (squared - on_axis * on_axis) / (squared * std::max(radius_ + contact.gap, kLeastFinger));
    }
    if (bend <= 0.02) return way;
    // The whole stretch only where the last move was on the same edges and corners, as most are left before it ends.
    std::uint64_t feature = 0;
    for (std::size_t k = 0; k < count; ++k)
        feature = feature * 0x9E3779B97F4A7C15u + 4 * held[k]->facet + static_cast<std::uint64_t>(held[k]->contact.feature) + 1;
    double by = 1 / std::max(1 - bend, 0.03);
    if (by > kMostStretch && (feature != last_ || long_left_ <= 0 || by * by * squared > radius_ * radius_ / 4))
        by = kMostStretch;
    if (by > kMostStretch) --long_left_;
    last_ = feature;
    const Point3 longer = way + (by - 1) * along;
    return kept({touching_.data(), count_}, longer) ? longer : way;
}

// What lies a little farther than the ball reaches is kept, and looked through while the ball stays in it.
bool ShadowPoint::look_around(int& work, bool anew) noexcept {
    const Point3 gone = place_ - near_.middle;
    if (const double room = near_.reach - radius_ - kTouches; !anew && room > 0 && dot(gone, gone) <= room * room) return true;
    const bool known = tree_->look_around(place_, radius_ + kTouches + around_, near_, work);
    if (!known)
        around_ /= 2;
    else if (near_.count < MeshVicinity::kMost / 6)
        around_ = std::min(2 * around_, kGrains * tree_->grain());
    return known;
}

// That is not known to be touched.
MeshTree::Near ShadowPoint::nearest_now(int& work) noexcept {
    const double most = radius_ + kTouches;
    std::array<std::uint32_t, kMost> known{};
    for (std::size_t k = 0; k < count_; ++k) known[k] = touching_[k].facet;
    const std::span<const std::uint32_t> but = std::span(known).first(count_);
    return look_around(work, false) ? tree_->nearest(place_, most, but, near_, work) : tree_->nearest(place_, most, but, work);
}

// Most ways end where they begin, within what is near.
MeshTree::Hit ShadowPoint::first_met(const Point3& way, std::span<const std::uint32_t> known, int& work) noexcept {
    for (bool anew = false; !anew || near_.middle != place_; anew = true) {
        if (!look_around(work, anew)) break;
        const Point3 gone = place_ - near_.middle;
        const double room = near_.reach - radius_, squared = dot(way, way), along = dot(gone, way);
        const double leaves = (std::sqrt(along * along + squared * (room * room - dot(gone, gone))) - along) / squared;
        const MeshTree::Hit hit = tree_->first_met(place_, way, radius_, known, std::min(leaves, 1.0), near_, work);
        if (hit.share <= 1 || leaves >= 1) return hit;
        if (anew) break;
    }
    return tree_->first_met(place_, way, radius_, known, work);
}

// So short a way that nothing can be passed: what the ball then reaches into is pushed out of by the next move.
bool ShadowPoint::roll(const Point3& way, int& work) noexcept {
    place_ = place_ + way;
    look_again();
    const MeshTree::Near near = nearest_now(work);
    if (near.gave_up) return false;
    if (near.distance <= radius_ + kTouches) {
        const Touching fresh{near.facet, contact_of(tree_->corners(near.facet), place_, radius_), 0};
        const auto alike =
            std::find_if(touching_.begin(), touching_.begin() + static_cast<std::ptrdiff_t>(count_),
                         [&](const Touching& one) { return dot(one.contact.normal, fresh.contact.normal) > kAlike; });
        if (alike == touching_.begin() + static_cast<std::ptrdiff_t>(count_))
            touch(near.facet);
        else if (fresh.contact.gap < alike->contact.gap)
            *alike = fresh;
    }
    if (std::all_of(touching_.begin(), touching_.begin() + static_cast<std::ptrdiff_t>(count_),
                    [](const Touching& one) { return one.contact.gap >= -kTouches; }))
        clear_ = place_;
    return true;
}

// Moves of a ball that is held to nothing new to be met on the way; false where they came to no end, and those that meet
// facets one by one may.
bool ShadowPoint::settle_by_rolling(const Point3& goal, int& work) noexcept {
    clear_ = place_;
    for (; moves_ < kMostRolls && work > enough_; ++moves_, work -= kMoveWork) {
        const Point3 wish = goal - place_;
        Point3 way;
        if (!allowed(wish, way)) break;
        const double squared = dot(way, way);
        settled_ = squared <= kStill * kStill;
        if (settled_ || (work < enough_ + tick_work_ / 4 && squared <= kAlmostStill * kAlmostStill)) return true;
        const bool straight = way == wish;
        if (!straight) way = stretched(way);
        const double length = std::sqrt(dot(way, way)), most = kRoll * radius_;
        if (straight && length > most) break;
        if (!roll(std::min(1.0, most / length) * way, work)) break;
    }
    place_ = clear_;
    look_again();
    return false;
}

void ShadowPoint::settle(const Point3& goal, int& work) noexcept {
    settled_ = false;
    std::array<std::uint32_t, 2 * kMost> known{};
    twins_ = 0;
    last_ = 0;
    long_left_ = kMostLong;
    enough_ = work - tick_work_;
    if (const Point3 from = place_; radius_ >= kLeastBall && !sweeps_) {
        if (settle_by_rolling(goal, work)) return;
        sweeps_ = work <= enough_ && place_ == from;
    } else {
        sweeps_ = false;
    }
    for (; moves_ < kMostMoves && work > enough_; ++moves_, work -= kMoveWork) {
        const Point3 wish = goal - place_;
        Point3 way;
        if (!allowed(wish, way)) return;
        if (dot(way, way) <= kStill * kStill) {
            settled_ = true;
            return;
        }
        const bool straight = way == wish;
        if (!straight) way = stretched(way);
        if (stride_ < 1) way = stride_ * way;
        for (std::size_t k = 0; k < count_; ++k) known[k] = touching_[k].facet;
        std::copy_n(twin_.begin(), twins_, known.begin() + static_cast<std::ptrdiff_t>(count_));
        const MeshTree::Hit hit = first_met(way, {known.data(), count_ + twins_}, work);
        if (hit.gave_up) {
            stride_ = std::max(stride_ / 2, kLeastStride);
            return;
        }
        if (hit.share > 1 && straight && stride_ >= 1) {
            place_ = goal;
            count_ = 0;
            settled_ = true;
            return;
        }
        stride_ = std::min(2 * stride_, 1.0);
        place_ = place_ + std::min(hit.share, 1.0) * way;
        if (hit.share > 0) {
            look_again();
            twins_ = 0;
        }
        if (hit.share <= 1) touch(hit.facet);
    }
}

// Gives false where there is too much to look at.
bool ShadowPoint::set_down(const Point3& finger, int& work) noexcept {
    count_ = 0;
    stride_ = 1;
    arrived_ = false;
    const MeshTree::Near near = tree_->nearest(finger, radius_, {}, work);
    const bool within = tree_->facets().closed && tree_->facets_above(finger, work) % 2 == 1;
    place_ = finger;
    const double top = tree_->high().z + 2 * radius_ + 1;
    if (near.gave_up || work <= 0 || within || near.distance <= radius_) place_.z = std::max(finger.z, top);
    return work > 0;
}

Point3 ShadowPoint::follow(Point3 finger) noexcept {
    moves_ = work_ = 0;
    if (!is_finite(finger)) return place_;
    for (double* at : {&finger.x, &finger.y, &finger.z}) *at = std::clamp(*at, -largest_, largest_);
    int work = kMostWork;
    if (lifted_ && !set_down(finger, work)) work = kMostWork;
    lifted_ = false;
    settle(finger, work);
    work_ = kMostWork - work;
    arrived_ = arrived_ || settled_;
    return place_;
}

}  // namespace tactics
