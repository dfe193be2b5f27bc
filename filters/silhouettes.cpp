// SPDX-License-Identifier: Apache-2.0
#include "filters/silhouettes.h"

#include <algorithm>

#include "filters/node_outlines.h"

namespace tactics {

namespace {

void add_up(Bulk& to, const Bulk& from) {
    to.area += from.area;
    to.outline += from.outline;
    to.sure += from.sure;
    for (std::size_t i = 0; i < 4; ++i) to.frame[i] += from.frame[i];
    to.box.take({from.box.left, from.box.top});
    to.box.take({from.box.right, from.box.bottom});
}

// Two that hold nothing in common, with what lies between them.
Bulk united(const Bulk& a, const Bulk& b, double between, double between_sure) {
    Bulk both = a;
    add_up(both, b);
    both.outline -= 2 * between;
    both.sure -= 2 * between_sure;
    return both;
}

}  // namespace

std::vector<Bulk> bulks_of(const RegionTree& tree, std::span<const float> chances) {
    std::vector<Bulk> bulks(tree.nodes.size());
    for (std::size_t i = 0; i < tree.faces(); ++i) {
        const RegionNode& node = tree.nodes[i];
        bulks[i].area = node.area;
        bulks[i].box = {static_cast<double>(node.box.left), static_cast<double>(node.box.top),
                        static_cast<double>(node.box.right), static_cast<double>(node.box.bottom)};
    }
    const auto w = static_cast<std::size_t>(tree.width), h = static_cast<std::size_t>(tree.height);
    for (std::size_t y = 0; y < h; ++y) {
        bulks[tree.face[y * w]].frame[0] += 1;
        bulks[tree.face[y * w + w - 1]].frame[2] += 1;
    }
    for (std::size_t x = 0; x < w; ++x) {
        bulks[tree.face[x]].frame[1] += 1;
        bulks[tree.face[(h - 1) * w + x]].frame[3] += 1;
    }
    // An arc is on the outlines of all that hold one of its faces; where both meet it is inside.
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const RegionArc& arc = tree.arcs[i];
        const double length = steps_of(arc), sure = length * static_cast<double>(chances[i]);
        for (const std::uint32_t f : arc.faces) {
            bulks[f].outline += length;
            bulks[f].sure += sure;
        }
        Bulk& meeting = bulks[meeting_of(tree, arc.faces[0], arc.faces[1])];
        meeting.outline -= 2 * length;
        meeting.sure -= 2 * sure;
    }
    for (std::size_t i = tree.faces(); i < tree.nodes.size(); ++i)
        for (const int c : tree.nodes[i].children) add_up(bulks[i], bulks[static_cast<std::size_t>(c)]);
    return bulks;
}

double overlap_of_boxes(const Box& a, const Box& b) {
    const double wide = std::min(a.right, b.right) - std::max(a.left, b.left),
                 high = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    if (wide <= 0 || high <= 0) return 0;
    const auto area = [](const Box& box) { return box.width() * box.height(); };
    return wide * high / (area(a) + area(b) - wide * high);
}

std::vector<Silhouette> pairs_of(const RegionTree& tree, std::span<const float> chances, const std::vector<Bulk>& bulks,
                                 const std::vector<std::size_t>& first, const std::vector<std::size_t>& second) {
    const FaceOrder order(tree);
    struct Between {
        double length = 0, sure = 0;
    };
    std::vector<Between> between(first.size() * second.size());
    std::vector<std::size_t> a[2], b[2];
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const RegionArc& arc = tree.arcs[i];
        const double length = steps_of(arc), sure = length * static_cast<double>(chances[i]);
        for (const std::size_t side : {0u, 1u}) {
            a[side].clear();
            b[side].clear();
            for (std::size_t n = 0; n < first.size(); ++n)
                if (order.holds(first[n], arc.faces[side])) a[side].push_back(n);
            for (std::size_t n = 0; n < second.size(); ++n)
                if (order.holds(second[n], arc.faces[side])) b[side].push_back(n);
        }
        for (const std::size_t side : {0u, 1u})
            for (const std::size_t n : a[side])
                for (const std::size_t m : b[1 - side]) {
                    between[n * second.size() + m].length += length;
                    between[n * second.size() + m].sure += sure;
                }
    }
    std::vector<Silhouette> pairs;
    for (std::size_t n = 0; n < first.size(); ++n)
        for (std::size_t m = 0; m < second.size(); ++m) {
            const Between& shared = between[n * second.size() + m];
            if (shared.length <= 0 || order.meet(first[n], second[m])) continue;
            pairs.push_back(
                {first[n], static_cast<int>(second[m]), united(bulks[first[n]], bulks[second[m]], shared.length, shared.sure)});
        }
    return pairs;
}

std::vector<bool> faces_in(const RegionTree& tree, const Silhouette& thing) {
    const FaceOrder order(tree);
    std::vector<bool> in(tree.faces());
    for (std::size_t f = 0; f < in.size(); ++f)
        in[f] = order.holds(thing.node, f) || (thing.other >= 0 && order.holds(static_cast<std::size_t>(thing.other), f));
    return in;
}

}  // namespace tactics
