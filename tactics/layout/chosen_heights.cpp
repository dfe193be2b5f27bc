// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/chosen_heights.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace tactics {

namespace {

using KindLengths = std::array<double, kLineKinds>;

// mm of line, with the round ends; a dot is as long as it is wide.
double felt_length(const PageStroke& stroke) {
    double length = stroke.width;
    for (std::size_t i = 1; i < stroke.points.size(); ++i) length += distance(stroke.points[i - 1], stroke.points[i]);
    if (stroke.closed && !stroke.points.empty()) length += distance(stroke.points.back(), stroke.points.front());
    return length;
}

double around(const Area& area) {
    double length = 0;
    for (const auto& ring : area.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) length += distance(ring[i], ring[(i + 1) % ring.size()]);
    return length;
}

KindLengths lengths_on(std::span<const Page> pages) {
    KindLengths lengths{};
    double& drawn = lengths[static_cast<std::size_t>(LineKind::drawn)];
    for (const Page& page : pages) {
        for (const PageStroke& stroke : page.strokes) lengths[static_cast<std::size_t>(kind_of(stroke))] += felt_length(stroke);
        for (const BrailleLine& line : page.braille)
            drawn += page.braille_dot * static_cast<double>(dots_of(line, page.cell).size());
        for (const Area& area : page.areas) drawn += around(area);
        if (page.picture) drawn += 2 * (page.picture->place.width + page.picture->place.height);
    }
    return lengths;
}

double bits_of(const KindLengths& lengths) {
    const double all = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    double bits = 0;
    for (const double length : lengths)
        if (length > 0) bits -= length / all * std::log2(length / all);
    return bits;
}

// Kinds are in order of height, so a step down between two neighbours or none is all that there is to choose: a bit for each.
std::array<int, kLineKinds> ranks_of(unsigned steps, const std::array<bool, kLineKinds>& there) {
    std::array<int, kLineKinds> ranks{};
    int rank = 0;
    bool any = false;
    for (std::size_t kind = 0; kind < kLineKinds; ++kind) {
        if (there[kind] && any) {
            rank += static_cast<int>(steps & 1u);
            steps >>= 1;
        }
        any = any || there[kind];
        ranks[kind] = rank;
    }
    return ranks;
}

}  // namespace

KindHeights kind_heights(std::span<const Page> pages, const DotHeights& dots) {
    const KindLengths lengths = lengths_on(pages);
    KindHeights heights{.dots = dots};
    std::transform(lengths.begin(), lengths.end(), heights.there.begin(), [](double length) { return length > 0; });
    const auto kinds = static_cast<unsigned>(std::count(heights.there.begin(), heights.there.end(), true));
    const double all = bits_of(lengths);
    if (kinds < 2) return heights;
    heights.losses.assign(std::min(kinds, static_cast<unsigned>(heights.most())), 1);
    double least = 1;
    for (unsigned steps = 0; steps < 1u << (kinds - 1); ++steps) {
        const auto used = static_cast<std::size_t>(std::popcount(steps)) + 1;
        if (used > heights.losses.size()) continue;
        const auto ranks = ranks_of(steps, heights.there);
        KindLengths of_height{};
        for (std::size_t kind = 0; kind < kLineKinds; ++kind) of_height[static_cast<std::size_t>(ranks[kind])] += lengths[kind];
        const double loss = std::max(0.0, 1 - bits_of(of_height) / all);
        heights.losses[used - 1] = std::min(heights.losses[used - 1], loss);
        if (loss >= least) continue;
        least = loss;
        heights.used = static_cast<int>(used);
        heights.rank = ranks;
    }
    return heights;
}

void choose_heights(Pages& pages, const DotHeights& dots) {
    const KindHeights chosen = kind_heights(pages.all, dots);
    for (Page& page : pages.all) page.heights = chosen;
    if (pages.large) pages.large->heights = chosen;
}

}  // namespace tactics
