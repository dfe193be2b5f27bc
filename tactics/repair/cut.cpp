// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "tactics/geometry/course.h"
#include "tactics/repair/means.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

constexpr double kSameCourse = 0.005;  // mm that points may be off a straight line and still go

struct Run {
    std::size_t begin = 0, count = 0;  // pieces of the chain, counted round a closed one
};

// Runs of pieces that are alike; a closed chain's first run may begin before its end.
std::vector<Run> runs_of(const std::vector<bool>& flags, bool value, bool closed) {
    const std::size_t n = flags.size();
    std::size_t start = 0;
    if (closed) {
        while (start < n && flags[start] == value) ++start;
        if (start == n) return {{0, n}};
    }
    std::vector<Run> runs;
    for (std::size_t i = 0; i < n; ++i) {
        const bool fits = flags[(start + i) % n] == value;
        const bool before = i > 0 && flags[(start + i - 1) % n] == value;
        if (fits && !before) runs.push_back({(start + i) % n, 0});
        if (fits) ++runs.back().count;
    }
    return runs;
}

std::vector<Point> points_of(const PageGeometry& geometry, const Chain& chain, Run run) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < run.count; ++k)
        points.push_back(geometry.pieces[chain.first + (run.begin + k) % chain.count].line.a);
    points.push_back(geometry.pieces[chain.first + (run.begin + run.count - 1) % chain.count].line.b);
    return course_of(points, kSameCourse);
}

double length_of(const PageGeometry& geometry, const Chain& chain, Run run) {
    double length = 0;
    for (std::size_t k = 0; k < run.count; ++k) {
        const Segment& line = geometry.pieces[chain.first + (run.begin + k) % chain.count].line;
        length += distance(line.a, line.b);
    }
    return length;
}

// Of two parts of one line that are too close, the later one has less worth, counted from the farthest tip of a closed line, so
// that one whole side of a thin bar's outline stays.
std::size_t tip_of(const PageGeometry& geometry, const Chain& chain) {
    if (!chain.closed) return 0;
    Point middle;
    for (std::size_t i = 0; i < chain.count; ++i) {
        const Point p = geometry.pieces[chain.first + i].line.a;
        middle = {middle.x + p.x / static_cast<double>(chain.count), middle.y + p.y / static_cast<double>(chain.count)};
    }
    std::size_t tip = 0;
    double farthest = -1;
    for (std::size_t i = 0; i < chain.count; ++i)
        if (const double away = distance(middle, geometry.pieces[chain.first + i].line.a); away > farthest) {
            farthest = away;
            tip = i;
        }
    return tip;
}

// What is too close to each piece and is of more worth, or is an earlier part of the same line: numbers of suspects.
class Rivals {
public:
    Rivals(const PageGeometry& geometry, const NearSuspects& near, double lacks, const std::vector<std::size_t>& worth)
        : begins_(geometry.pieces.size() + 1) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> rivals;  // the lesser piece, and the number of the suspect
        std::vector<std::size_t> tips;
        for (const Chain& chain : geometry.chains) tips.push_back(tip_of(geometry, chain));
        const auto place = [&](std::uint32_t piece) {
            const std::uint32_t c = geometry.pieces[piece].chain;
            const Chain& chain = geometry.chains[c];
            return (piece - chain.first + chain.count - tips[c]) % chain.count;
        };
        for (std::size_t i = 0; i < near.size(); ++i) {
            const auto [one, other, lack, white] = near[i];
            if (!(lack > lacks + kRounding)) continue;
            const std::uint32_t a = geometry.pieces[one].chain, b = geometry.pieces[other].chain;
            const std::uint32_t lesser = (a == b ? place(one) > place(other) : worth[a] < worth[b]) ? one : other;
            if (geometry.chains[geometry.pieces[lesser].chain].ring) continue;  // outline_areas sees to it
            rivals.push_back({lesser, static_cast<std::uint32_t>(i)});
            ++begins_[lesser + 1];
        }
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        numbers_.resize(rivals.size());
        std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
        for (const auto& [lesser, number] : rivals) numbers_[next[lesser]++] = number;
    }
    bool empty() const { return numbers_.empty(); }
    std::span<const std::uint32_t> of(std::size_t piece) const {
        return std::span(numbers_).subspan(begins_[piece], begins_[piece + 1] - begins_[piece]);
    }

private:
    std::vector<std::uint32_t> begins_, numbers_;
};

// Which pieces go: from the most worthy chain to the least, and what has gone takes nothing with it. Nothing: none.
std::vector<bool> pieces_to_go(const PageGeometry& geometry, const Drawing& drawing, NearSuspects& near, double lacks) {
    const std::vector<std::size_t> worth = worth_of(geometry, drawing);
    const Rivals rivals(geometry, near, lacks, worth);
    if (rivals.empty()) return {};
    std::vector<std::size_t> by_worth(worth.size());
    for (std::size_t c = 0; c < worth.size(); ++c) by_worth[worth.size() - 1 - worth[c]] = c;
    std::vector<bool> gone(geometry.pieces.size());
    bool any = false;
    for (const std::size_t c : by_worth) {
        const Chain& chain = geometry.chains[c];
        const std::size_t tip = tip_of(geometry, chain);
        for (std::size_t k = 0; k < chain.count; ++k) {
            const std::size_t piece = chain.first + (tip + k) % chain.count;
            const auto all = rivals.of(piece);
            gone[piece] = std::any_of(all.begin(), all.end(), [&](std::uint32_t number) {
                const auto suspect = near[number];
                return !gone[suspect.one == piece ? suspect.other : suspect.one] && near.is_too_close(number);
            });
            any = any || gone[piece];
        }
    }
    if (!any) gone.clear();
    return gone;
}

}  // namespace

std::vector<Stroke> without(const Stroke& stroke, const PageGeometry& geometry, const Chain& chain, const std::vector<bool>& gone,
                            double shortest, double along, Mends& changes) {
    std::vector<Stroke> left;
    std::vector<bool> lost = gone;
    for (const Run run : runs_of(gone, false, chain.closed)) {
        if (length_of(geometry, chain, run) < shortest) {
            for (std::size_t k = 0; k < run.count; ++k) lost[(run.begin + k) % chain.count] = true;
            continue;
        }
        left.push_back({points_of(geometry, chain, run), false, stroke.line, stroke.strength, stroke.role});
    }
    const auto at = [&](Run run) { return geometry.pieces[chain.first + (run.begin + run.count / 2) % chain.count].line.a; };
    if (left.empty()) {
        changes.push_back({Mend::Kind::left_out, at({0, chain.count}), chain.length});
        return left;
    }
    for (const Run run : runs_of(lost, true, chain.closed)) {
        const double length = length_of(geometry, chain, run);
        const bool end = !chain.closed && (run.begin == 0 || run.begin + run.count == chain.count);
        changes.push_back({length > along ? Mend::Kind::merged
                           : end          ? Mend::Kind::shortened
                                          : Mend::Kind::broken,
                           at(run), length});
    }
    return left;
}

Mends cut_lesser(Drawing& drawing, const Medium& medium, Seen& seen, double lacks, Vicinity& changed) {
    const PageGeometry& geometry = seen.geometry;
    Mends changes;
    const std::vector<bool> gone = pieces_to_go(geometry, drawing, seen.near, lacks);
    if (gone.empty()) return changes;
    const double reach = reach_of_change(geometry, medium);
    std::vector<Stroke> strokes;
    for (const Chain& chain : geometry.chains) {
        if (chain.ring) continue;
        const auto first = gone.begin() + static_cast<std::ptrdiff_t>(chain.first);
        const std::vector<bool> own(first, first + static_cast<std::ptrdiff_t>(chain.count));
        Stroke& stroke = drawing.strokes[chain.owner];
        if (std::find(own.begin(), own.end(), true) == own.end()) {
            strokes.push_back(std::move(stroke));
            continue;
        }
        for (std::size_t i = chain.first; i < chain.first + chain.count; ++i) changed.add(geometry.box_of_piece(i, reach));
        for (Stroke& part : without(stroke, geometry, chain, own, medium.shortest, 2 * medium.gap, changes))
            strokes.push_back(std::move(part));
    }
    drawing.strokes = std::move(strokes);
    return changes;
}

}  // namespace tactics
