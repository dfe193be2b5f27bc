// SPDX-License-Identifier: Apache-2.0
#include "tactics/repair/near.h"

#include <algorithm>
#include <numeric>
#include <string_view>

#include "tactics/geometry/evidence.h"
#include "tactics/rules/narrow.h"

namespace tactics {

namespace {

// A little more than the rule asks, so that writing hundredths of a millimetre does not break it again.
constexpr double kRoom = 4 * kRounding;

}  // namespace

Page page_of(const Drawing& drawing, const Medium& medium) {
    Page page;
    page.width = drawing.width;
    page.height = drawing.height;
    page.live = {0, 0, drawing.width, drawing.height};
    page.strokes.reserve(drawing.strokes.size());
    for (const Stroke& stroke : drawing.strokes)
        page.strokes.push_back({stroke.points, stroke.closed, width_of(stroke.line, medium), stroke.role});
    // Patterns are drawn after repair and give way by themselves. Their areas are no ink; an empty one stands in for each, so
    // that the others keep their numbers.
    for (const Area& area : drawing.areas) page.areas.push_back(area.texture == 0 ? area : Area{});
    return page;
}

NearPairs near_pairs(const PageGeometry& geometry, const Medium& medium, double lacks, const Vicinity* where) {
    NearPairs near;
    const auto look = [&](std::string_view name, Apart apart) {
        const auto limit = limit_of(*find_rule(name), medium);
        if (!limit || *limit + kRoom <= lacks) return;
        const NarrowPairs found = narrow_pairs(geometry, *limit + kRoom - lacks, apart, where);
        for (const NarrowPair& pair : found.pairs)
            near.pairs.push_back({pair.one, pair.other, pair.at, pair.other_at, *limit + kRoom - pair.measured});
        near.work += found.work;
        near.complete = near.complete && found.complete;
    };
    look("gap", Apart::edges);
    near.gaps = near.pairs.size();
    look("merging-dots", Apart::middles);
    return near;
}

double reach_of_change(const PageGeometry& geometry, const Medium& medium) {
    double widest = 0;
    for (const std::string_view name : {"gap", "merging-dots"})
        widest = std::max(widest, limit_of(*find_rule(name), medium).value_or(0) + kRoom);
    return reach_of_change(geometry, widest);
}

Seen::Seen(const Drawing& drawing, const Medium& medium, const Vicinity* where, double lacks)
    : page(page_of(drawing, medium)), geometry(page), near(near_pairs(geometry, medium, lacks, where)) {}

// A drawing has no margins and no braille.
Broken broken_rules(const Seen& seen, const Medium& medium) {
    Broken broken{0, seen.near.complete};
    // Between each two chains the rules tell the narrowest place.
    const auto count = [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint64_t> chains;
        for (std::size_t i = begin; i < end; ++i) {
            const NearPair& pair = seen.near.pairs[i];
            if (pair.lacks <= kRoom + kRounding) continue;
            const std::uint64_t a = seen.geometry.pieces[pair.one].chain, b = seen.geometry.pieces[pair.other].chain;
            chains.push_back(std::min(a, b) << 32 | std::max(a, b));
        }
        std::sort(chains.begin(), chains.end());
        const auto places = static_cast<std::size_t>(std::unique(chains.begin(), chains.end()) - chains.begin());
        broken.places += std::min(places, kMostPlaces);
        broken.complete = broken.complete && places <= kMostPlaces;
    };
    count(0, seen.near.gaps);
    count(seen.near.gaps, seen.near.pairs.size());
    for (const Demand& demand : demands_of(medium)) {
        if (!demand.rule->hard || demand.rule == find_rule("gap") || demand.rule == find_rule("merging-dots")) continue;
        const Findings findings = demand.rule->check(seen.geometry, demand.limit);
        broken.places += findings.places.size();
        broken.complete = broken.complete && findings.complete;
    }
    return broken;
}

std::vector<std::size_t> worth_of(const PageGeometry& geometry, const Drawing& drawing) {
    std::vector<std::size_t> place(drawing.strokes.size());
    const auto order = by_evidence(drawing.strokes);
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = order.size() - i;
    std::vector<std::uint32_t> chains(geometry.chains.size());
    std::iota(chains.begin(), chains.end(), 0u);
    std::sort(chains.begin(), chains.end(), [&](std::uint32_t i, std::uint32_t j) {
        const Chain &a = geometry.chains[i], &b = geometry.chains[j];
        if (a.ring != b.ring) return b.ring;
        if (a.ring) return a.length != b.length ? a.length < b.length : i > j;
        if (a.half_width != b.half_width) return a.half_width < b.half_width;
        return place[a.owner] < place[b.owner];
    });
    std::vector<std::size_t> worth(chains.size());
    for (std::size_t i = 0; i < chains.size(); ++i) worth[chains[i]] = i;
    return worth;
}

}  // namespace tactics
