// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/crossings.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tactics/repair/means.h"

namespace tactics {

namespace {

// A line that is broken into pieces shorter than this is no line any more (BANA 3.4.3.2: 1/2 in); then it stays whole.
constexpr double kPiece = 12.7;
// With less of a difference in strength neither is the lesser.
constexpr double kClearlyLess = 0.8;

bool is_less(const Stroke& a, const Stroke& b) {
    if (a.line != b.line) return a.line < b.line;
    return a.strength > 0 && b.strength > 0 && a.strength < kClearlyLess * b.strength;
}

// So many are no drawing that a gap here and there would mend.
constexpr std::size_t kMostCrossings = 5000;

struct Span {
    double begin, end;  // mm along the chain
};

// The part of the lesser line to remove: everything closer to the other than the gap, on both sides of the crossing.
Span span_at(const PageGeometry& geometry, const Station& at, const Chain& other, double clear) {
    const Chain& chain = geometry.chains[at.chain];
    const auto is_near = [&](double along) {
        const Point p = geometry.point_at({at.chain, along});
        for (std::size_t i = other.first; i < other.first + other.count; ++i)
            if (distance(nearest_on(geometry.pieces[i].line, p), p) < clear) return true;
        return false;
    };
    constexpr double kStep = 0.25;
    Span span{at.along, at.along};
    const double most = 4 * clear;
    while (at.along - span.begin < most && is_near(span.begin)) span.begin -= kStep;
    while (span.end - at.along < most && is_near(span.end)) span.end += kStep;
    if (!chain.closed) span = {std::max(span.begin, 0.0), std::min(span.end, chain.length)};
    return span;
}

// Pieces that a span covers, even in part.
void mark(const PageGeometry& geometry, const Chain& chain, Span span, std::vector<bool>& gone) {
    for (std::size_t i = 0; i < chain.count; ++i) {
        const Piece& piece = geometry.pieces[chain.first + i];
        const double begin = piece.along, end = begin + distance(piece.line.a, piece.line.b);
        for (const double lap : {-chain.length, 0.0, chain.length})
            if (begin + lap < span.end && end + lap > span.begin && (lap == 0 || chain.closed)) gone[i] = true;
    }
}

// No part between two gaps, or a gap and an end, is too short.
bool leaves_lines(const PageGeometry& geometry, const Chain& chain, const std::vector<bool>& gone) {
    Mends unused;
    const Stroke plain{geometry.points_of(chain), chain.closed};
    double kept = 0, pieces = 0;
    for (std::size_t i = 0; i < chain.count; ++i) {
        const Segment& line = geometry.pieces[chain.first + i].line;
        if (!gone[i]) pieces += distance(line.a, line.b);
    }
    for (const Stroke& part : without(plain, geometry, chain, gone, kPiece, chain.length, unused)) kept += length_of(part);
    return kept > 0 && kept > pieces - 0.1;
}

}  // namespace

Mends break_crossings(Drawing& drawing, const Medium& medium, const PageGeometry& geometry) {
    Mends changes;
    bool complete = true;
    std::map<std::uint32_t, std::vector<bool>> gone;  // pieces of chains that are broken
    const std::vector<Meeting> meetings = find_meetings(geometry, complete);
    if (!complete || meetings.size() > kMostCrossings) return changes;
    for (const Meeting& meeting : meetings) {
        if (meeting.one.chain == meeting.other.chain) continue;
        const auto less = [&](const Station& a, const Station& b) {
            return is_less(drawing.strokes[geometry.chains[a.chain].owner], drawing.strokes[geometry.chains[b.chain].owner]);
        };
        const bool one_less = less(meeting.one, meeting.other);
        if (!one_less && !less(meeting.other, meeting.one)) continue;
        const Station &lesser = one_less ? meeting.one : meeting.other, &greater = one_less ? meeting.other : meeting.one;
        const Chain &chain = geometry.chains[lesser.chain], &other = geometry.chains[greater.chain];
        auto& flags = gone.try_emplace(static_cast<std::uint32_t>(lesser.chain), chain.count).first->second;
        std::vector<bool> with = flags;
        mark(geometry, chain, span_at(geometry, lesser, other, medium.gap + chain.half_width + other.half_width), with);
        if (leaves_lines(geometry, chain, with)) flags = std::move(with);
    }
    std::erase_if(
        gone, [](const auto& chain) { return std::find(chain.second.begin(), chain.second.end(), true) == chain.second.end(); });
    if (gone.empty()) return changes;
    std::vector<Stroke> strokes;
    for (std::uint32_t c = 0; c < geometry.chains.size(); ++c) {
        const Chain& chain = geometry.chains[c];
        if (chain.ring) continue;
        const auto broken = gone.find(c);
        if (broken == gone.end()) {
            strokes.push_back(std::move(drawing.strokes[chain.owner]));
            continue;
        }
        for (Stroke& part : without(drawing.strokes[chain.owner], geometry, chain, broken->second, 0, chain.length, changes))
            strokes.push_back(std::move(part));
    }
    drawing.strokes = std::move(strokes);
    return changes;
}

}  // namespace tactics
