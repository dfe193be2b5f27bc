// SPDX-License-Identifier: Apache-2.0
// Where lines cross, a finger can take the wrong one.
#include "tactics/rules/crossings.h"

#include <algorithm>
#include <numeric>

#include "tactics/rules/rule.h"

namespace tactics {

namespace {

constexpr std::size_t kCrossingsMostPairs = 100'000'000;
constexpr std::size_t kMostMeetings = 200'000;

double side_of(const Segment& line, Point p) {
    return (line.b.x - line.a.x) * (p.y - line.a.y) - (line.b.y - line.a.y) * (p.x - line.a.x);
}

// Does the line go on, beyond the ink of the other, on both sides of it?
bool passes(const PageGeometry& geometry, const Piece& piece, Point at, const Segment& other, double reach) {
    const Chain& chain = geometry.chains[piece.chain];
    const double along = piece.along + distance(piece.line.a, at);
    if (!chain.closed && (along < reach || along > chain.length - reach)) return false;
    const double before = side_of(other, geometry.point_at({piece.chain, along - reach}));
    const double after = side_of(other, geometry.point_at({piece.chain, along + reach}));
    return (before > 0 && after < 0) || (before < 0 && after > 0);
}

}  // namespace

std::vector<Meeting> find_meetings(const PageGeometry& geometry, bool& complete) {
    std::vector<std::uint32_t> lines;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < geometry.pieces.size(); ++i) {
        // A tick mark is there to cross its axis; a texture that a line runs through is the rule texture-clearance's.
        const Chain& chain = geometry.chains[geometry.pieces[i].chain];
        const Role role = geometry.role_of(chain);
        if (chain.ring || role == Role::tick || role == Role::pattern) continue;
        lines.push_back(static_cast<std::uint32_t>(i));
        boxes.push_back(box_of(geometry.pieces[i].line, kTouch));
    }
    std::vector<Meeting> meetings;
    const Grid grid(std::move(boxes), geometry.page.width, geometry.page.height);
    complete = grid.pairs(kCrossingsMostPairs, [&](std::size_t i, std::size_t j) {
        const Piece &p = geometry.pieces[lines[i]], &q = geometry.pieces[lines[j]];
        const Chain &a = geometry.chains[p.chain], &b = geometry.chains[q.chain];
        const double reach = a.half_width + b.half_width + kTouch;
        if (p.chain == q.chain && geometry.way(a, p.along, q.along) <= 4 * reach) return true;
        const Nearest near = nearest(p.line, q.line);
        if (near.distance > 1e-9 || !passes(geometry, p, near.one, q.line, reach) ||
            !passes(geometry, q, near.one, p.line, reach))
            return true;
        meetings.push_back({near.one,
                            {p.chain, p.along + distance(p.line.a, near.one)},
                            {q.chain, q.along + distance(q.line.a, near.other)},
                            reach});
        return meetings.size() < kMostMeetings;
    });
    return meetings;
}

namespace {

Findings check_crossings(const PageGeometry& geometry, double limit) {
    Findings findings;
    const std::vector<Meeting> meetings = find_meetings(geometry, findings.complete);
    // Meetings within each other's ink are one place, with all the lines that go through it.
    std::vector<Box> boxes;
    for (const Meeting& m : meetings) boxes.push_back(box_of({m.at, m.at}, m.reach / 2));
    std::vector<std::uint32_t> first(meetings.size());
    std::iota(first.begin(), first.end(), 0u);
    const auto root = [&first](std::uint32_t m) {
        while (first[m] != m) m = first[m] = first[first[m]];
        return m;
    };
    const Grid grid(std::move(boxes), geometry.page.width, geometry.page.height);
    findings.complete &= grid.pairs(kCrossingsMostPairs, [&](std::size_t i, std::size_t j) {
        if (distance(meetings[i].at, meetings[j].at) > std::max(meetings[i].reach, meetings[j].reach)) return true;
        const std::uint32_t a = root(static_cast<std::uint32_t>(i)), b = root(static_cast<std::uint32_t>(j));
        first[std::max(a, b)] = std::min(a, b);
        return true;
    });
    std::vector<std::vector<std::uint32_t>> through(meetings.size());
    for (std::uint32_t m = 0; m < meetings.size(); ++m) {
        auto& lines = through[root(m)];
        lines.push_back(static_cast<std::uint32_t>(meetings[m].one.chain));
        // A line that crosses itself goes through twice; no chain has that number.
        const std::size_t other = meetings[m].other.chain;
        lines.push_back(static_cast<std::uint32_t>(other == meetings[m].one.chain ? other + geometry.chains.size() : other));
    }
    for (std::size_t m = 0; m < meetings.size(); ++m) {
        auto& lines = through[m];
        std::sort(lines.begin(), lines.end());
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
        const auto count = static_cast<double>(lines.size());
        if (count > limit)
            findings.places.push_back({count, meetings[m].at, {}, phrase("{0} lines that cross at one place", shown(count))});
    }
    return findings;
}

}  // namespace

extern const Rule crossings_rule;
const Rule crossings_rule{
    .name = "crossings",
    .summary = "no lines that cross each other",
    .mend = "break the lesser line and leave a gap on both sides of the other",
    .source = "accessiblegraphics.org and BANA Guidelines 2.11, 3.4.3.13: where lines cross, the less important one is broken",
    .confidence = Confidence::good,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 1,
              .min = 1,
              .max = 100,
              .summary = "maximum number of lines through one place; 2 allows plain crossings"},
    .check = check_crossings,
};

}  // namespace tactics
