// SPDX-License-Identifier: Apache-2.0
#include "print/kind_heights.h"

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
        for (const PageStroke& stroke : page.strokes)
            lengths[static_cast<std::size_t>(line_kind(stroke.role))] += felt_length(stroke);
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

LineKind line_kind(Role role) {
    switch (role) {
        case Role::axis:
        case Role::tick:
        case Role::lead:
        case Role::scale:
        case Role::mark: return LineKind::values;
        case Role::grid: return LineKind::grid;
        case Role::pattern: return LineKind::pattern;
        case Role::line:
        case Role::dash:
        case Role::arrow:
        case Role::symbol: break;
    }
    return LineKind::drawn;
}

KindHeights kind_heights(std::span<const Page> pages, int most) {
    const KindLengths lengths = lengths_on(pages);
    KindHeights heights{.most = most};
    std::transform(lengths.begin(), lengths.end(), heights.there.begin(), [](double length) { return length > 0; });
    const auto kinds = static_cast<unsigned>(std::count(heights.there.begin(), heights.there.end(), true));
    const double all = bits_of(lengths);
    if (kinds < 2) return heights;
    heights.losses.assign(std::min(kinds, static_cast<unsigned>(most)), 1);
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

Dots kinds_on_bed(const Page& page) {
    constexpr auto kLowest = static_cast<std::uint8_t>(kLineKinds);
    Dots kinds = raise_on_bed(page);
    for (std::uint8_t& dot : kinds.raised) dot = dot != 0 ? kLowest : 0;
    // With the lines of lower kinds first, so that a higher one takes the dots that it shares with them.
    Page higher = page;
    for (std::uint8_t kind = kLowest - 1; kind > 0; --kind) {
        std::erase_if(higher.strokes,
                      [kind](const PageStroke& stroke) { return static_cast<std::uint8_t>(line_kind(stroke.role)) >= kind; });
        const Dots dots = raise_on_bed(higher);
        for (std::size_t i = 0; i < dots.raised.size(); ++i)
            if (dots.raised[i] != 0 && kinds.raised[i] != 0) kinds.raised[i] = kind;
    }
    return kinds;
}

}  // namespace tactics
