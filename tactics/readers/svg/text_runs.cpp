// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/text_runs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/drawing.h"
#include "tactics/readers/svg/plain_words.h"

namespace tactics {

namespace {

// Settings, in em: letters overlap by less, and stand no farther apart; a space is no wider; off the line is an index or an
// exponent, and no farther. Shares of the size of the line: those are smaller, and what goes on is as large.
constexpr double kOverlapOfRuns = 0.15, kNoSpace = 0.16, kWidestSpace = 0.5, kOnLine = 0.06, kOffBase = 0.75;
constexpr double kSmaller = 0.88, kSmallest = 0.4;

struct Offset {
    double along = 0, down = 0;  // of where the next begins, from where the line ends; em of the line
};

Offset offset_of(const TextRun& line, const TextRun& next) {
    const double length = distance(line.start, line.end);
    const Point way = {(line.end.x - line.start.x) / length, (line.end.y - line.start.y) / length};
    const Point to = {next.start.x - line.end.x, next.start.y - line.end.y};
    return {(to.x * way.x + to.y * way.y) / line.em, (to.y * way.x - to.x * way.y) / line.em};
}

// They run the same way.
bool are_level(const TextRun& a, const TextRun& b) {
    constexpr double kStraight = 0.999;
    const double both = distance(a.start, a.end) * distance(b.start, b.end);
    const double dot = (a.end.x - a.start.x) * (b.end.x - b.start.x) + (a.end.y - a.start.y) * (b.end.y - b.start.y);
    return both > 0 && dot >= kStraight * both;
}

// What stands between a line and what goes on with it, with that; nothing: it is another line.
std::optional<std::string> going_on(const FoundWords& line, const FoundWords& next) {
    if (!line.run || !next.run || !are_level(*line.run, *next.run)) return std::nullopt;
    const Offset off = offset_of(*line.run, *next.run);
    const double ratio = next.run->em / line.run->em;
    if (off.along < -kOverlapOfRuns || off.along > kWidestSpace || ratio < kSmallest || ratio > 1 / kSmaller) return std::nullopt;
    if (ratio < kSmaller && std::abs(off.down) > kOnLine) {
        if (off.along > kNoSpace || std::abs(off.down) > kOffBase) return std::nullopt;
        return off_line(next.text, off.down < 0);
    }
    if (std::abs(off.down) > kOnLine || ratio < kSmaller) return std::nullopt;
    return (off.along > kNoSpace ? " " : "") + next.text;
}

void take(FoundWords& line, const FoundWords& next, const std::string& said) {
    const TextRun &own = *line.run, &other = *next.run;
    const double length = distance(own.start, own.end),
                 more = offset_of(own, other).along * own.em + distance(other.start, other.end);
    const Point way = {(own.end.x - own.start.x) / length, (own.end.y - own.start.y) / length};
    line.text += said;
    line.run->end = {own.end.x + more * way.x, own.end.y + more * way.y};
    line.middle = {line.middle.x + more / 2 * way.x, line.middle.y + more / 2 * way.y};
    line.width += more;
}

}  // namespace

void join_text_runs(std::vector<FoundWords>& words) {
    std::vector<FoundWords> joined;
    for (FoundWords& next : words) {
        const auto said = joined.empty() ? std::nullopt : going_on(joined.back(), next);
        if (said)
            take(joined.back(), next, *said);
        else
            joined.push_back(std::move(next));
    }
    words = std::move(joined);
}

}  // namespace tactics
