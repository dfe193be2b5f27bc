// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/mesh_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace tactics {

namespace {

struct Float3 {
    float at[3];
    Float3(float x, float y, float z) : at{x, y, z} {}
    explicit Float3(const Point3& p) : at{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)} {}
};

}  // namespace

// `wanted` gives how far a box is, negative where it is not wanted; nearer boxes come first. `look` sees a leaf, and gives how
// many facets it looked at. False where the work ran out.
template <typename Wanted, typename Look>
bool MeshTree::walk(int& work, Wanted wanted, Look look) const noexcept {
    if (nodes_.empty()) return true;
    struct Later {
        std::int32_t child;
        float far;
    };
    std::array<Later, kMostDepth> later;
    std::size_t count = 0;
    std::int32_t at = 0;
    for (;;) {
        if (at < 0) {
            work -= 1 + 4 * look(leaves_[static_cast<std::size_t>(-1 - at)]);
        } else {
            const Node& node = nodes_[static_cast<std::size_t>(at)];
            --work;
            const float one = wanted(node.low[0], node.high[0]), other = wanted(node.low[1], node.high[1]);
            if (one >= 0 || other >= 0) {
                const bool first = other < 0 || (one >= 0 && one <= other);
                if (one >= 0 && other >= 0 && count < kMostDepth)
                    later[count++] = {node.child[first ? 1 : 0], first ? other : one};
                at = node.child[first ? 0 : 1];
                if (work <= 0) return false;
                continue;
            }
        }
        if (work <= 0) return false;
        if (count == 0) return true;
        at = later[--count].child;
    }
}

namespace {

float squared_distance(const float* low, const float* high, const Float3& place) noexcept {
    float sum = 0;
    for (int k = 0; k < 3; ++k) {
        const float off = std::max(std::max(low[k] - place.at[k], place.at[k] - high[k]), 0.0f);
        sum += off * off;
    }
    return sum;
}

// A place or a way in a leaf's own directions.
template <typename Leaf>
Float3 turned(const Leaf& leaf, const float* at) noexcept {
    const float *o = leaf.over, *a = leaf.along;
    const float across[3] = {o[1] * a[2] - o[2] * a[1], o[2] * a[0] - o[0] * a[2], o[0] * a[1] - o[1] * a[0]};
    const auto on = [&](const float* axis) { return axis[0] * at[0] + axis[1] * at[1] + axis[2] * at[2]; };
    return Float3(on(a), on(across), on(o));
}

template <typename Leaf>
float squared_distance(const Leaf& leaf, const Float3& place) noexcept {
    const float off[3] = {place.at[0] - leaf.middle[0], place.at[1] - leaf.middle[1], place.at[2] - leaf.middle[2]};
    const Float3 at = turned(leaf, off);
    float sum = 0;
    for (int k = 0; k < 3; ++k) {
        const float beyond = std::max(std::abs(at.at[k]) - leaf.half[k], 0.0f);
        sum += beyond * beyond;
    }
    return sum;
}

// Whether a way up to that share of it passes a leaf's box, made larger by that.
template <typename Leaf>
bool in_way_of(const Leaf& leaf, const Float3& start, const Float3& along, float share, float inflated) noexcept {
    const float off[3] = {start.at[0] - leaf.middle[0], start.at[1] - leaf.middle[1], start.at[2] - leaf.middle[2]};
    const Float3 from = turned(leaf, off), to = turned(leaf, along.at);
    float enter = 0, leave = share * (1 + 1e-6f);
    for (int k = 0; k < 3; ++k) {
        const float by = 1 / (to.at[k] == 0 ? 1e-30f : to.at[k]), wide = leaf.half[k] + inflated;
        const float one = (-wide - from.at[k]) * by, other = (wide - from.at[k]) * by;
        enter = std::max(enter, std::min(one, other));
        leave = std::min(leave, std::max(one, other));
    }
    return enter <= leave * (1 + 1e-5f) + 1e-6f;
}

// Squared, for boxes whose places are rounded.
float reach_of(double distance, float slack) noexcept {
    const float reach = static_cast<float>(distance) * (1 + 1e-6f) + 2 * slack;
    return reach * reach;
}

}  // namespace

MeshTree::Hit MeshTree::first_met(const Point3& ball, const Point3& way, double radius, std::span<const std::uint32_t> known,
                                  int& work) const noexcept {
    Hit hit;
    const double length = length_of(way);
    const float inflated = static_cast<float>(radius) + 2 * slack_;
    double before = 1;
    // The ball around what is left of the way; boxes beside the way itself are left to the lines below.
    Float3 middle(ball), start(ball);
    float reach = 0;
    const auto shorten = [&] {
        middle = Float3(ball + before / 2 * way);
        reach = static_cast<float>(radius + before / 2 * length) * (1 + 1e-6f) + 2 * slack_;
        reach *= reach;
    };
    shorten();
    const bool thin = length > 2 * radius;
    float inverse[3];
    const Float3 along(way);
    for (int k = 0; k < 3; ++k) inverse[k] = 1 / (along.at[k] == 0 ? 1e-30f : along.at[k]);
    const auto wanted = [&](const float* low, const float* high) noexcept -> float {
        const float far = squared_distance(low, high, middle);
        if (!(far <= reach)) return -1;
        if (!thin) return far;
        float enter = 0, leave = static_cast<float>(before) * (1 + 1e-6f);
        for (int k = 0; k < 3; ++k) {
            const float one = (low[k] - inflated - start.at[k]) * inverse[k],
                        other = (high[k] + inflated - start.at[k]) * inverse[k];
            enter = std::max(enter, std::min(one, other));
            leave = std::min(leave, std::max(one, other));
        }
        return enter <= leave * (1 + 1e-5f) + 1e-6f ? enter : -1;
    };
    const auto look_at = [&](std::uint32_t facet) noexcept {
        if (std::find(known.begin(), known.end(), facet) != known.end()) return;
        const double share = meeting(corners(facet), ball, way, length, radius, before);
        if (share > before || (share == before && hit.share <= 1)) return;
        hit.share = share;
        hit.facet = facet;
        before = share;
        shorten();
    };
    const auto look = [&](const Leaf& leaf) noexcept {
        if (!(squared_distance(leaf, middle) <= reach)) return 0;
        if (thin && !in_way_of(leaf, start, along, static_cast<float>(before), inflated)) return 0;
        for (std::uint32_t facet = leaf.first; facet < leaf.first + leaf.count; ++facet) look_at(facet);
        return static_cast<int>(leaf.count);
    };
    hit.gave_up = !walk(work, wanted, look);
    return hit;
}

// Nothing is said of a facet beyond `least`.
void MeshTree::look_for_nearest(const Leaf& leaf, const Point3& place, std::span<const std::uint32_t> but, double& least,
                                Near& near) const noexcept {
    for (std::uint32_t facet = leaf.first; facet < leaf.first + leaf.count; ++facet) {
        const double distance = distance_to(corners(facet), place, least);
        if (distance > least || distance >= near.distance || std::find(but.begin(), but.end(), facet) != but.end()) continue;
        near.distance = distance;
        near.facet = facet;
        least = distance;
    }
}

MeshTree::Near MeshTree::nearest(const Point3& place, double most, std::span<const std::uint32_t> but, int& work) const noexcept {
    Near near;
    const Float3 at(place);
    double least = most;
    const auto reach = [&] { return reach_of(least, slack_); };
    const auto wanted = [&](const float* low, const float* high) noexcept -> float {
        const float far = squared_distance(low, high, at);
        return far <= reach() ? far : -1;
    };
    const auto look = [&](const Leaf& leaf) noexcept {
        if (!(squared_distance(leaf, at) <= reach())) return 0;
        look_for_nearest(leaf, place, but, least, near);
        return static_cast<int>(leaf.count);
    };
    near.gave_up = !walk(work, wanted, look);
    return near;
}

MeshTree::Near MeshTree::nearest(const Point3& place, double most, std::span<const std::uint32_t> but,
                                 std::span<const std::uint32_t> leaves, int& work) const noexcept {
    Near near;
    const Float3 at(place);
    double least = most;
    for (const std::uint32_t number : leaves) {
        const Leaf& leaf = leaves_[number];
        --work;
        if (!(squared_distance(leaf, at) <= reach_of(least, slack_))) continue;
        look_for_nearest(leaf, place, but, least, near);
        work -= 3 * static_cast<int>(leaf.count);
    }
    return near;
}

int MeshTree::leaves_near(const Point3& place, double reach, std::span<std::uint32_t> leaves, int& work) const noexcept {
    const Float3 at(place);
    const float far = reach_of(reach, slack_);
    std::size_t count = 0;
    bool all = true;
    const auto wanted = [&](const float* low, const float* high) noexcept -> float {
        return squared_distance(low, high, at) <= far ? 0.0f : -1.0f;
    };
    const auto look = [&](const Leaf& leaf) noexcept {
        if (!(squared_distance(leaf, at) <= far)) return 0;
        all = all && count < leaves.size();
        if (all) leaves[count++] = static_cast<std::uint32_t>(&leaf - leaves_.data());
        return 0;
    };
    return walk(work, wanted, look) && all ? static_cast<int>(count) : -1;
}

// Seen from above an edge is to the left or to the right of the place, never on it: computed from the same ends in the same order
// for both of its facets, it is the same for both.
int MeshTree::facets_above(const Point3& place, int& work) const noexcept {
    const Float3 at(place);
    const auto wanted = [&](const float* low, const float* high) noexcept -> float {
        const bool over = at.at[0] >= low[0] - slack_ && at.at[0] <= high[0] + slack_ && at.at[1] >= low[1] - slack_ &&
                          at.at[1] <= high[1] + slack_ && at.at[2] <= high[2] + slack_;
        return over ? 0.0f : -1.0f;
    };
    int count = 0;
    const auto look_at = [&](std::uint32_t facet) noexcept {
        const auto& numbers = facets_.facets[facet];
        int turns = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t one = numbers[k], other = numbers[(k + 1) % 3];
            const Point3 &a = facets_.corners[std::min(one, other)], &b = facets_.corners[std::max(one, other)];
            const bool left = (b.x - a.x) * (place.y - a.y) - (b.y - a.y) * (place.x - a.x) > 0;
            turns += left == (one < other) ? 1 : -1;
        }
        if (turns != 3 && turns != -3) return;
        const FacetCorners f = corners(facet);
        const Point3 over = cross(f.b - f.a, f.c - f.a);
        const double height = dot(over, place - f.a);
        if (over.z > 0 ? height < 0 : height > 0) ++count;
    };
    const auto look = [&](const Leaf& leaf) noexcept {
        for (std::uint32_t facet = leaf.first; facet < leaf.first + leaf.count; ++facet) look_at(facet);
        return static_cast<int>(leaf.count);
    };
    walk(work, wanted, look);
    return count;
}

}  // namespace tactics
