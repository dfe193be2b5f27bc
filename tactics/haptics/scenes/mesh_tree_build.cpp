// SPDX-License-Identifier: Apache-2.0
// How the tree is built.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "tactics/haptics/scenes/mesh_tree.h"

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
        if (part.end - part.first <= kLeaf) {
            tree.leaves_.push_back({{}, {}, {}, {}, part.first, part.end - part.first});
            return -static_cast<std::int32_t>(tree.leaves_.size());
        }
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
    for (Leaf& leaf : leaves_) leaf = leaf_of(leaf.first, leaf.count);
}

MeshTree::Leaf MeshTree::leaf_of(std::uint32_t first, std::uint32_t count) const {
    Leaf leaf{{}, {}, {}, {}, first, count};
    Point3 over, longest;
    for (std::uint32_t facet = first; facet < first + count; ++facet) {
        const FacetCorners f = corners(facet);
        for (const Point3& side : {f.b - f.a, f.c - f.b, f.a - f.c})
            if (dot(side, side) > dot(longest, longest)) longest = side;
        const Point3 turned = cross(f.b - f.a, f.c - f.a);
        over = over + (dot(over, turned) < 0 ? -1.0 : 1.0) * turned;  // both sides of a sheet lie in its plane
    }
    over = (1 / length_of(over)) * over;
    Point3 along = longest - dot(longest, over) * over;
    if (!(dot(along, along) > 1e-6 * dot(longest, longest)))  // facets that stand across one another: any direction will do
        along = cross(over, std::abs(over.x) < 0.7 ? Point3{1, 0, 0} : Point3{0, 1, 0});
    along = (1 / length_of(along)) * along;
    const std::array<Point3, 3> axes{along, cross(over, along), over};
    Point3 middle;
    for (std::size_t k = 0; k < 3; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (std::uint32_t facet = first; facet < first + count; ++facet)
            for (const std::uint32_t corner : facets_.facets[facet]) {
                const double at = dot(axes[k], facets_.corners[corner]);
                low = std::min(low, at);
                high = std::max(high, at);
            }
        middle = middle + (low / 2 + high / 2) * axes[k];
        leaf.half[k] = static_cast<float>(high / 2 - low / 2);
    }
    const auto narrow = [](const Point3& from, float* to) {
        to[0] = static_cast<float>(from.x);
        to[1] = static_cast<float>(from.y);
        to[2] = static_cast<float>(from.z);
    };
    narrow(middle, leaf.middle);
    narrow(over, leaf.over);
    narrow(along, leaf.along);
    return leaf;
}

}  // namespace tactics
