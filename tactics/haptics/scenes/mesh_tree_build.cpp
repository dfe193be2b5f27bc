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
constexpr std::int32_t kNone = INT32_MAX;

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

    struct Half {
        Box box;
        std::int32_t child = kNone;
    };
    std::vector<std::array<Half, 2>> pairs;
    std::vector<std::array<std::uint32_t, 2>> leaves;  // first, count

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

    // The box around the part, and its child: a pair, or, negative, a leaf of the tree.
    Half build(const Part& part) {
        Half half;
        for (std::uint32_t i = part.first; i < part.end; ++i) half.box.add(boxes[order[i]]);
        if (part.end - part.first <= kLeaf) {
            leaves.push_back({part.first, part.end - part.first});
            half.child = -static_cast<std::int32_t>(leaves.size());
            return half;
        }
        const std::uint32_t middle = cut(part);
        half.child = static_cast<std::int32_t>(pairs.size());
        pairs.emplace_back();
        const auto number = static_cast<std::size_t>(half.child);
        const Half first = build({part.first, middle, part.depth + 1}), second = build({middle, part.end, part.depth + 1});
        pairs[number] = {first, second};
        return half;
    }

    // Up to four of what is below a half, the larger boxes opened first, become a node of the tree; its number.
    std::int32_t widen(const Half& half) {
        std::array<Half, 4> wide{half};
        for (std::size_t count = 1; count < 4; ++count) {
            std::size_t largest = count;
            for (std::size_t k = 0; k < count; ++k)
                if (wide[k].child >= 0 && (largest == count || wide[k].box.area() > wide[largest].box.area())) largest = k;
            if (largest == count) break;
            const std::array<Half, 2>& pair = pairs[static_cast<std::size_t>(wide[largest].child)];
            wide[largest] = pair[0];
            wide[count] = pair[1];
        }
        const std::size_t number = tree.nodes_.size();
        tree.nodes_.emplace_back();
        for (std::size_t k = 0; k < 4; ++k) {
            if (wide[k].child == kNone) continue;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                tree.nodes_[number].boxes.low[axis][k] = wide[k].box.low[axis];
                tree.nodes_[number].boxes.high[axis][k] = wide[k].box.high[axis];
            }
            tree.nodes_[number].child[k] = wide[k].child;
            if (wide[k].child < 0) continue;
            const std::int32_t child = widen(wide[k]);
            tree.nodes_[number].child[k] = child;
        }
        return static_cast<std::int32_t>(number);
    }
};

MeshTree::MeshTree(MeshFacets facets) : facets_(std::move(facets)) {
    if (facets_.facets.empty()) return;
    Builder builder{*this, {}, std::vector<std::uint32_t>(facets_.facets.size()), {}, {}};
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
    const Builder::Half root = builder.build({0, static_cast<std::uint32_t>(facets_.facets.size()), 0});
    nodes_.reserve(builder.leaves.size() / 2 + 1);
    builder.widen(root);
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
    leaves_.reserve(builder.leaves.size());
    for (const auto& [first, count] : builder.leaves) {
        std::array<FacetCorners, kLeaf> facet;
        for (std::uint32_t k = 0; k < count; ++k) facet[k] = this->corners(first + k);
        leaves_.emplace_back(facet.data(), first, count);
        grain_ += 2 * double{leaves_.back().size} / static_cast<double>(builder.leaves.size());
    }
}

}  // namespace tactics
