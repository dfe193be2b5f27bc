// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/mesh_tree.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace tactics {

namespace {

constexpr std::uint32_t kLeaf = 4;     // facets at most
constexpr int kBins = 16, kDeep = 40;  // below that depth halves are made, so that the tree ends

struct Box {
    std::array<float, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    void add(const Box& other) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
    float area() const noexcept {
        const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        return x * y + y * z + z * x;
    }
    float middle(std::size_t k) const noexcept { return low[k] / 2 + high[k] / 2; }
};

// Leaves: the first facet and how many, in one number below 0.
std::int32_t leaf_of(std::uint32_t first, std::uint32_t count) { return -1 - static_cast<std::int32_t>(first * 4 + count - 1); }

}  // namespace

struct MeshTree::Builder {
    MeshTree& tree;
    std::vector<Box> boxes;
    std::vector<std::uint32_t> order;

    struct Part {
        std::uint32_t first, end;
        int depth;
    };

    // Where the part is cut in two: after sorting, the place in `order`.
    std::uint32_t cut(const Part& part) {
        Box middles;
        for (std::uint32_t i = part.first; i < part.end; ++i) {
            const Box& box = boxes[order[i]];
            const std::array<float, 3> middle{box.middle(0), box.middle(1), box.middle(2)};
            middles.add({middle, middle});
        }
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (middles.high[k] - middles.low[k] > middles.high[axis] - middles.low[axis]) axis = k;
        const float from = middles.low[axis], wide = middles.high[axis] - from;
        const std::uint32_t half = part.first + (part.end - part.first) / 2;
        if (!(wide > 0)) return half;
        const auto begin = order.begin() + part.first, end = order.begin() + part.end;
        if (part.depth >= kDeep) {
            std::nth_element(begin, order.begin() + half, end,
                             [&](std::uint32_t a, std::uint32_t b) { return boxes[a].middle(axis) < boxes[b].middle(axis); });
            return half;
        }
        const auto bin_of = [&](std::uint32_t facet) {
            const float share = (boxes[facet].middle(axis) - from) / wide;
            return std::min(static_cast<std::size_t>(share * kBins), std::size_t{kBins - 1});
        };
        std::array<Box, kBins> bins;
        std::array<std::uint32_t, kBins> counts{};
        for (auto i = begin; i != end; ++i) {
            const std::size_t bin = bin_of(*i);
            bins[bin].add(boxes[*i]);
            ++counts[bin];
        }
        const std::size_t best = cheapest(bins, counts);
        const auto middle = std::partition(begin, end, [&](std::uint32_t facet) { return bin_of(facet) < best; });
        return middle == begin || middle == end ? half : part.first + static_cast<std::uint32_t>(middle - begin);
    }

    // The bin that the second half begins with.
    static std::size_t cheapest(const std::array<Box, kBins>& bins, const std::array<std::uint32_t, kBins>& counts) {
        std::array<float, kBins> behind{};
        Box all;
        std::uint32_t count = 0;
        for (std::size_t bin = kBins; bin-- > 1;) {
            all.add(bins[bin]);
            count += counts[bin];
            behind[bin] = count > 0 ? all.area() * static_cast<float>(count) : 0;
        }
        all = {};
        count = 0;
        std::size_t best = kBins / 2;
        float least = INFINITY;
        for (std::size_t bin = 1; bin < kBins; ++bin) {
            all.add(bins[bin - 1]);
            count += counts[bin - 1];
            const float cost = (count > 0 ? all.area() * static_cast<float>(count) : 0) + behind[bin];
            if (cost < least) {
                least = cost;
                best = bin;
            }
        }
        return best;
    }

    std::int32_t build(const Part& part, Box& around) {
        around = {};
        for (std::uint32_t i = part.first; i < part.end; ++i) around.add(boxes[order[i]]);
        if (part.end - part.first <= kLeaf) return leaf_of(part.first, part.end - part.first);
        const std::uint32_t middle = cut(part);
        const std::size_t number = tree.nodes_.size();
        tree.nodes_.emplace_back();
        const std::array<Part, 2> halves{{{part.first, middle, part.depth + 1}, {middle, part.end, part.depth + 1}}};
        for (std::size_t k = 0; k < 2; ++k) {
            Box box;
            const std::int32_t child = build(halves[k], box);
            Node& node = tree.nodes_[number];
            node.child[k] = child;
            std::copy(box.low.begin(), box.low.end(), node.low[k]);
            std::copy(box.high.begin(), box.high.end(), node.high[k]);
        }
        return static_cast<std::int32_t>(number);
    }
};

MeshTree::MeshTree(MeshFacets facets) : facets_(std::move(facets)) {
    if (facets_.facets.empty()) return;
    Builder builder{*this, {}, std::vector<std::uint32_t>(facets_.facets.size())};
    std::iota(builder.order.begin(), builder.order.end(), 0u);
    builder.boxes.reserve(facets_.facets.size());
    Box all;
    for (const auto& facet : facets_.facets) {
        Box box;
        for (const std::uint32_t corner : facet) {
            const Point3& at = facets_.corners[corner];
            const std::array<float, 3> near{static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
            box.add({near, near});
        }
        all.add(box);
        builder.boxes.push_back(box);
    }
    float largest = 0;
    for (std::size_t k = 0; k < 3; ++k) largest = std::max({largest, -all.low[k], all.high[k]});
    slack_ = 1e-6f * largest + 1e-6f;  // rounding to 24 bits, in boxes and in what is computed from them
    low_ = Point3{all.low[0], all.low[1], all.low[2]} - Point3{slack_, slack_, slack_};
    high_ = Point3{all.high[0], all.high[1], all.high[2]} + Point3{slack_, slack_, slack_};
    nodes_.reserve(facets_.facets.size() / 2 + 1);
    Box around;
    const std::int32_t root = builder.build({0, static_cast<std::uint32_t>(facets_.facets.size()), 0}, around);
    if (root < 0) {  // a leaf alone: its other half is a box that nothing meets
        Node only{};
        for (std::size_t k = 0; k < 3; ++k) {
            only.low[0][k] = around.low[k];
            only.high[0][k] = around.high[k];
            only.low[1][k] = INFINITY;
            only.high[1][k] = -INFINITY;
        }
        only.child[0] = only.child[1] = root;
        nodes_.push_back(only);
    }
    std::vector<std::array<std::uint32_t, 3>> sorted;
    sorted.reserve(builder.order.size());
    for (const std::uint32_t number : builder.order) sorted.push_back(facets_.facets[number]);
    facets_.facets = std::move(sorted);
    // Corners in the order in which facets have them, so that neighbours are near in memory, too.
    std::vector<std::uint32_t> place(facets_.corners.size(), UINT32_MAX);
    std::vector<Point3> corners;
    corners.reserve(place.size());
    for (auto& facet : facets_.facets)
        for (std::uint32_t& corner : facet) {
            if (place[corner] == UINT32_MAX) {
                place[corner] = static_cast<std::uint32_t>(corners.size());
                corners.push_back(facets_.corners[corner]);
            }
            corner = place[corner];
        }
    facets_.corners = std::move(corners);
}

// `wanted` gives how far a box is, negative where it is not wanted; nearer boxes come first. `look` sees a facet. False where the
// work ran out.
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
            const std::uint32_t code = static_cast<std::uint32_t>(-1 - at), first = code / 4, size = code % 4 + 1;
            for (std::uint32_t facet = first; facet < first + size; ++facet) look(facet);
            work -= 4 * static_cast<int>(size);
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

struct Float3 {
    float at[3];
    explicit Float3(const Point3& p) : at{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)} {}
};

float squared_distance(const float* low, const float* high, const Float3& place) noexcept {
    float sum = 0;
    for (int k = 0; k < 3; ++k) {
        const float off = std::max(std::max(low[k] - place.at[k], place.at[k] - high[k]), 0.0f);
        sum += off * off;
    }
    return sum;
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
    const auto look = [&](std::uint32_t facet) noexcept {
        if (std::find(known.begin(), known.end(), facet) != known.end()) return;
        const double share = meeting(corners(facet), ball, way, length, radius, before);
        if (share > before || (share == before && hit.share <= 1)) return;
        hit.share = share;
        hit.facet = facet;
        before = share;
        shorten();
    };
    hit.gave_up = !walk(work, wanted, look);
    return hit;
}

MeshTree::Near MeshTree::nearest(const Point3& place, double most, int& work) const noexcept {
    Near near;
    const Float3 at(place);
    double least = most;
    const auto wanted = [&](const float* low, const float* high) noexcept -> float {
        const float far = squared_distance(low, high, at), reach = static_cast<float>(least) * (1 + 1e-6f) + 2 * slack_;
        return far <= reach * reach ? far : -1;
    };
    const auto look = [&](std::uint32_t facet) noexcept {
        const double distance = contact_of(corners(facet), place, 0).gap;
        if (distance > least || distance >= near.distance) return;
        near.distance = distance;
        near.facet = facet;
        least = distance;
    };
    near.gave_up = !walk(work, wanted, look);
    return near;
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
    const auto look = [&](std::uint32_t facet) noexcept {
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
    walk(work, wanted, look);
    return count;
}

}  // namespace tactics
