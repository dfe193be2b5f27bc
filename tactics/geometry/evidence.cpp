// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/evidence.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tactics {

double evidence_of(const Stroke& stroke) {
    const double length = length_of(stroke);
    return stroke.strength > 0 ? static_cast<double>(stroke.strength) * std::pow(length, 0.25) : length;
}

std::vector<std::size_t> by_evidence(const std::vector<Stroke>& strokes) {
    struct Rank {
        bool seen;
        double evidence;
    };
    std::vector<Rank> ranks;
    ranks.reserve(strokes.size());
    for (const Stroke& stroke : strokes) ranks.push_back({stroke.strength > 0, evidence_of(stroke)});
    std::vector<std::size_t> order(strokes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (ranks[a].seen != ranks[b].seen) return ranks[a].seen;
        return ranks[a].evidence > ranks[b].evidence;
    });
    return order;
}

}  // namespace tactics
