// SPDX-License-Identifier: Apache-2.0
#include "tactics/repair/near.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

#include "tactics/geometry/evidence.h"
#include "tactics/rules/narrow.h"

namespace tactics {

namespace {

// A little more than the rule asks, so that writing hundredths of a millimetre does not break it again.
constexpr double kRoom = 4 * kRounding;

// The hard rules for distances that the medium has: visit(limit, apart), with the room.
template <typename Visit>
void each_distance(const Medium& medium, Visit visit) {
    constexpr std::pair<std::string_view, Apart> kRules[] = {{"gap", Apart::edges}, {"merging-dots", Apart::middles}};
    for (const auto& [name, apart] : kRules)
        if (const auto limit = limit_of(*find_rule(name), medium)) visit(*limit + kRoom, apart);
}

void add(NearPairs& near, const NarrowPairs& found, double limit) {
    for (const NarrowPair& pair : found.pairs)
        near.pairs.push_back({pair.one, pair.other, pair.at, pair.other_at, limit - pair.measured});
    near.work += found.work;
    near.complete = near.complete && found.complete;
}

}  // namespace

Page page_of(const Drawing& drawing, const Medium& medium) {
    Page page;
    page.width = drawing.width;
    page.height = drawing.height;
    page.live = {0, 0, drawing.width, drawing.height};
    page.strokes.reserve(drawing.strokes.size());
    for (const Stroke& stroke : drawing.strokes)
        page.strokes.push_back({stroke.points, stroke.closed, width_of(stroke.line, medium), stroke.role});
    // Patterns are drawn after repair and yield on their own. Their areas are no ink; an empty area replaces each, so that the
    // others keep their numbers.
    for (const Area& area : drawing.areas) page.areas.push_back(area.texture == 0 ? area : Area{});
    return page;
}

NearSuspects::NearSuspects(const PageGeometry& geometry, const Medium& medium, double lacks, const Vicinity* where)
    : geometry_(geometry), begins_{0} {
    each_distance(medium, [&](double limit, Apart apart) {
        if (!(limit > lacks)) return;
        rules_.push_back({limit, apart, {geometry, limit - lacks, apart, where}});
        begins_.push_back(begins_.back() + rules_.back().suspects.all().size());
    });
}

NearSuspects::Suspect NearSuspects::operator[](std::size_t number) const {
    const std::size_t number_of_rule = rule_of(number);
    const ByRule& rule = rules_[number_of_rule];
    const auto [one, other, measured] = rule.suspects.all()[number - begins_[number_of_rule]];
    const double ink =
        geometry_.chains[geometry_.pieces[one].chain].half_width + geometry_.chains[geometry_.pieces[other].chain].half_width;
    return {one, other, rule.limit - measured, rule.apart == Apart::edges ? measured : measured - ink};
}

NearPair NearSuspects::pair(std::size_t number) const {
    const auto [one, other, lacks, white] = (*this)[number];
    const Nearest near = nearest(geometry_.pieces[one].line, geometry_.pieces[other].line);
    return {one, other, near.one, near.other, lacks};
}

bool NearSuspects::is_too_close(std::size_t number) {
    const std::size_t rule = rule_of(number);
    return rules_[rule].suspects.is_narrow(number - begins_[rule]);
}

bool NearSuspects::any_too_close() {
    for (std::size_t i = 0; i < size(); ++i)
        if (is_too_close(i)) return true;
    return false;
}

bool NearSuspects::complete() const {
    return std::all_of(rules_.begin(), rules_.end(), [](const ByRule& rule) { return rule.suspects.complete(); });
}

MovingNearPairs::MovingNearPairs(const PageGeometry& geometry, const Medium& medium, double lacks, double moves) {
    each_distance(medium, [&](double limit, Apart apart) {
        if (limit > lacks) rules_.push_back({limit, apart, {geometry, limit - lacks, apart, moves}});
    });
}

NearPairs MovingNearPairs::pairs(std::span<const Segment> now, std::size_t most) {
    NearPairs near;
    for (ByRule& rule : rules_) add(near, rule.moving.pairs(now, most), rule.limit);
    return near;
}

double reach_of_change(const PageGeometry& geometry, const Medium& medium) {
    double widest = kRoom;
    each_distance(medium, [&widest](double limit, Apart) { widest = std::max(widest, limit); });
    return reach_of_change(geometry, widest);
}

Seen::Seen(const Drawing& drawing, const Medium& medium, const Vicinity* where, double lacks)
    : page(page_of(drawing, medium)), geometry(page), near(geometry, medium, lacks, where) {}

// A drawing has no margins and no braille.
Broken broken_rules(Seen& seen, const Medium& medium) {
    Broken broken;
    // Between each two chains the rules tell the narrowest place, so only one is asked for.
    const auto count = [&](std::size_t begin, std::size_t end) {
        constexpr std::size_t kLately = 1 << 12;
        std::vector<std::uint64_t> chains, lately(kLately);
        for (std::size_t i = begin; i < end; ++i) {
            const auto [one, other, lacks, white] = seen.near[i];
            if (lacks <= kRoom + kRounding) continue;
            const std::uint64_t a = seen.geometry.pieces[one].chain, b = seen.geometry.pieces[other].chain;
            const std::uint64_t both = std::min(a, b) << 32 | std::max(a, b), told = both + 1;  // 0: none
            std::uint64_t& known = lately[both * 0x9e3779b97f4a7c15 >> 52];
            if (known == told || !seen.near.is_too_close(i)) continue;
            known = told;
            chains.push_back(both);
        }
        std::sort(chains.begin(), chains.end());
        const auto places = static_cast<std::size_t>(std::unique(chains.begin(), chains.end()) - chains.begin());
        broken.places += std::min(places, kMostPlaces);
        broken.complete = broken.complete && places <= kMostPlaces;
    };
    for (std::size_t rule = 0; rule + 1 < seen.near.begins().size(); ++rule)
        count(seen.near.begins()[rule], seen.near.begins()[rule + 1]);
    broken.complete = broken.complete && seen.near.complete();
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
