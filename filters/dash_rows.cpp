// SPDX-License-Identifier: Apache-2.0
#include "filters/dash_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "filters/dash_crossings.h"
#include "filters/dash_pieces.h"
#include "tactics/geometry/vectors.h"

namespace tactics {

namespace {

constexpr std::size_t kLeast = 4;          // dashes of a line; three in a row are dots after a word
constexpr std::size_t kLeastLeading = 2;   // of a line from one thing to another
constexpr double kOnCourse = 0.86;         // cosine of what a line may turn from dash to dash: 30 degrees
constexpr double kClearLength = 2;         // pixels
constexpr double kThinnest = 1.3;          // pixels; what is thinner is blurred
constexpr double kLongDash = 2.5;          // widths of a dash that has a direction of its own
constexpr std::size_t kMostDashes = 4000;  // of a picture; more is a pattern or noise

struct Link {
    std::size_t a, b;  // ends: 2 * dash + which
    double gap;
};

class Rows {
public:
    Rows(std::vector<InkedDash> dashes, double reach, const std::vector<HidingMark>& marks)
        : dashes_(std::move(dashes)), links_(2 * dashes_.size(), kNone), hidden_(2 * dashes_.size()) {
        std::vector<Link> all;
        for (std::size_t i = 0; i < dashes_.size(); ++i)
            for (std::size_t j = i + 1; j < dashes_.size(); ++j) {
                if (distance(dashes_[i].middle(), dashes_[j].middle()) >
                    reach_of(i, j, reach) + (dashes_[i].length() + dashes_[j].length()) / 2)
                    continue;
                for (std::size_t e = 0; e < 2; ++e)
                    for (std::size_t f = 0; f < 2; ++f) {
                        const double gap = distance(dashes_[i].ends[e], dashes_[j].ends[f]);
                        if (gap <= reach_of(i, j, reach) && go_on(i, e, j, f)) all.push_back({2 * i + e, 2 * j + f, gap});
                    }
            }
        join(std::move(all));
        part_from_dashes();
        for (const HidingMark& mark : marks) join_behind(mark, reach);
        join(bridges());
        join(corners(), false);
    }

    // Of rows that are long enough, the ends at which each of their dashes begins, in their order.
    std::vector<std::vector<std::size_t>> chains() const {
        std::vector<std::vector<std::size_t>> all;
        std::vector<bool> seen(dashes_.size());
        for (std::size_t i = 0; i < dashes_.size(); ++i) {
            if (seen[i]) continue;
            // Back to its beginning, or once around.
            std::size_t first = 2 * i;
            while (links_[first] != kNone && links_[first] / 2 != i) first = links_[first] ^ 1;
            if (links_[first] != kNone) first = 2 * i;
            std::vector<std::size_t> chain;
            for (std::size_t end = first; end != kNone && !seen[end / 2]; end = links_[end ^ 1]) {
                seen[end / 2] = true;
                chain.push_back(end);
            }
            if (chain.size() >= kLeastLeading) all.push_back(std::move(chain));
        }
        return all;
    }
    std::vector<double> gaps(const std::vector<std::size_t>& chain) const {
        std::vector<double> all;
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            if (!hidden_[chain[i] ^ 1])
                all.push_back(distance(dash(chain[i]).ends[1 - (chain[i] & 1)], dash(chain[i + 1]).ends[chain[i + 1] & 1]));
        return all;
    }
    const InkedDash& dash(std::size_t end) const { return dashes_[end / 2]; }
    // It may be longer than what is seen of it.
    bool is_cut(std::size_t end) const { return hidden_[end] || hidden_[end ^ 1]; }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    // Long dashes have long gaps.
    double reach_of(std::size_t i, std::size_t j, double reach) const {
        constexpr double kGapOfDash = 1.8, kMostReach = 1.6;
        return std::clamp(kGapOfDash * std::min(dashes_[i].whole_length(), dashes_[j].whole_length()), reach, kMostReach * reach);
    }

    void join(std::vector<Link> all, bool on_course = true) {
        std::stable_sort(all.begin(), all.end(), [](const Link& a, const Link& b) { return a.gap < b.gap; });
        for (const Link& link : all)
            if (links_[link.a] == kNone && links_[link.b] == kNone && links_[link.a ^ 1] != link.b &&
                (!on_course || keeps_course(link))) {
                links_[link.a] = link.b;
                links_[link.b] = link.a;
            }
    }

    // The two ends that lead to the mark from about opposite sides, the nearest: a curve may turn at its points.
    void join_behind(const HidingMark& mark, double reach) {
        constexpr double kLeadsTo = 0.7, kTurn = 0.3;  // cosines
        std::vector<std::pair<double, std::size_t>> ends;
        for (std::size_t end = 0; end < links_.size(); ++end) {
            const Point at = dashes_[end / 2].ends[end & 1], way{mark.middle.x - at.x, mark.middle.y - at.y};
            const double far = std::hypot(way.x, way.y);
            if (links_[end] != kNone || far > mark.radius + reach) continue;
            const std::size_t before = links_[end ^ 1];
            const Point own =
                before == kNone ? direction(end / 2, end & 1) : Point{at.x - near_end(before).x, at.y - near_end(before).y};
            if (cosine(own, way) >= kLeadsTo) ends.emplace_back(far, end);
        }
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const std::size_t a = ends[i].second, b = ends[j].second;
                const Point from = dashes_[a / 2].ends[a & 1], to = dashes_[b / 2].ends[b & 1];
                if (links_[a] != kNone || links_[b] != kNone || a / 2 == b / 2 || !have_one_hue(dashes_[a / 2], dashes_[b / 2]) ||
                    cosine({mark.middle.x - from.x, mark.middle.y - from.y}, {to.x - mark.middle.x, to.y - mark.middle.y}) <
                        kTurn)
                    continue;
                links_[a] = b;
                links_[b] = a;
                hidden_[a] = hidden_[b] = true;
            }
    }

    struct RowEnd {
        std::size_t end, row, dashes;
        Point at, out;  // its way, from the dash `back` of it
        double gap, width, length, period;
        DashKind kind;
    };
    // Of rows of so many dashes that do not run around.
    std::vector<RowEnd> row_ends(std::size_t least, std::size_t back) const {
        std::vector<RowEnd> ends;
        std::size_t number = 0;
        for (const std::vector<std::size_t>& chain : chains()) {
            ++number;
            if (chain.size() < least || links_[chain.front()] != kNone || gaps(chain).empty()) continue;
            std::vector<double> lengths, widths;
            for (const std::size_t end : chain) {
                lengths.push_back(dash(end).whole_length());
                widths.push_back(dash(end).width);
            }
            const double gap = middle_length(gaps(chain)), width = middle_length(widths), length = middle_length(lengths),
                         period = *std::max_element(lengths.begin(), lengths.end()) + gap;
            for (double& one : lengths) one /= std::max(kThinnest, width);
            const DashKind kind = dash_kind(std::move(lengths));
            const auto add = [&](std::size_t end, std::size_t before) {
                const Point at = dash(end).ends[end & 1], from = dash(before).middle();
                const double way = std::max(1e-6, distance(from, at));
                ends.push_back({end,
                                number,
                                chain.size(),
                                at,
                                {(at.x - from.x) / way, (at.y - from.y) / way},
                                gap,
                                width,
                                length,
                                period,
                                kind});
            };
            const std::size_t last = chain.size() - 1, inner = std::min(back, last);
            add(chain.front(), chain[inner]);
            add(chain.back() ^ 1, chain[last - inner]);
        }
        return ends;
    }

    // Where a row ends and another one begins after the usual gap, in another direction: the corner of a curve that joins
    // measurements by straight lines.
    std::vector<Link> corners() const {
        constexpr std::size_t kFew = 2, kRow = 3;           // dashes of both, and of one of them
        constexpr double kUsualGap = 1.5, kWider = 1.6;     // times
        constexpr double kTurns = -0.2, kTurnsBack = -0.6;  // cosines
        const auto alike = [](double one, double other) { return std::max(one, other) <= kWider * std::min(one, other) + 1; };
        const std::vector<RowEnd> ends = row_ends(kFew, 1);
        std::vector<Link> all;
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const RowEnd &a = ends[i], &b = ends[j];
                const double gap = distance(a.at, b.at);
                if (a.row == b.row || std::max(a.dashes, b.dashes) < kRow || gap > kUsualGap * std::min(a.gap, b.gap) + 1)
                    continue;
                if (!alike(a.width, b.width) || !alike(a.length, b.length) || !alike(a.gap, b.gap)) continue;
                if (!have_one_hue(dash(a.end), dash(b.end))) continue;
                const Point way{b.at.x - a.at.x, b.at.y - a.at.y}, on{-b.out.x, -b.out.y};
                if (std::min(cosine(a.out, way), cosine(on, way)) < kTurns || cosine(a.out, on) < kTurnsBack) continue;
                all.push_back({a.end, b.end, gap});
            }
        return all;
    }

    // From the end of a row over what it crosses, where dashes are one piece of ink with that, to the row that goes on behind it.
    std::vector<Link> bridges() const {
        constexpr double kPeriods = 3;       // of dash and gap
        constexpr double kStraightOn = 0.8;  // cosine of 37 degrees, of an arc from its chord
        const std::vector<RowEnd> ends = row_ends(kLeast, 2);
        std::vector<Link> all;
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const RowEnd &a = ends[i], &b = ends[j];
                const Point way{b.at.x - a.at.x, b.at.y - a.at.y};
                const double gap = distance(a.at, b.at);
                if (a.row == b.row || a.kind != b.kind || gap > kPeriods * std::min(a.period, b.period)) continue;
                if (!have_one_hue(dash(a.end), dash(b.end))) continue;
                const double on = std::min(cosine(a.out, way), cosine({-b.out.x, -b.out.y}, way));
                if (on >= kStraightOn) all.push_back({a.end, b.end, gap * (2 - on)});
            }
        return all;
    }

    // A dash has a direction if it is clearly longer than wide; a dot has that of the pixels' corners.
    Point direction(std::size_t dash, std::size_t end) const {
        const InkedDash& one = dashes_[dash];
        if (one.length() < std::max(one.width, kClearLength)) return {};
        return {one.ends[end].x - one.ends[1 - end].x, one.ends[end].y - one.ends[1 - end].y};
    }

    bool go_on(std::size_t i, std::size_t e, std::size_t j, std::size_t f) const {
        if (!have_one_hue(dashes_[i], dashes_[j])) return false;
        const Point a = dashes_[i].middle(), b = dashes_[j].middle(), way{b.x - a.x, b.y - a.y};
        const Point out = direction(i, e), in = direction(j, f);
        return cosine(out, way) >= kOnCourse && cosine({-in.x, -in.y}, way) >= kOnCourse;
    }

    // Dots get their direction from those that they are joined to; a long dash has its own, and may be bent.
    bool keeps_course(const Link& link) const {
        for (const auto& [end, next] : {std::pair{link.a, link.b}, std::pair{link.b, link.a}}) {
            const std::size_t other = links_[end ^ 1];
            const InkedDash& own = dashes_[end / 2];
            if (other == kNone || own.whole_length() > kLongDash * own.width) continue;
            const Point from = near_end(other), to = near_end(next), middle = own.middle();
            if (cosine({middle.x - from.x, middle.y - from.y}, {to.x - middle.x, to.y - middle.y}) < kOnCourse) return false;
        }
        return true;
    }

    Point near_end(std::size_t end) const {
        constexpr double kIn = 0.3;  // of half a dash: the end itself may be a pixel off
        const InkedDash& one = dashes_[end / 2];
        const Point at = one.ends[end & 1], middle = one.middle();
        return {at.x + kIn * (middle.x - at.x), at.y + kIn * (middle.y - at.y)};
    }

    // A dash of another line among dots, where they cross.
    void part_from_dashes() {
        constexpr double kFarLonger = 4;  // widths
        for (const std::vector<std::size_t>& chain : chains()) {
            std::vector<double> lengths, widths;
            for (const std::size_t end : chain) {
                lengths.push_back(dash(end).whole_length());
                widths.push_back(dash(end).width);
            }
            const double width = std::max(kThinnest, middle_length(std::move(widths)));
            std::vector<double> in_widths = lengths;
            for (double& length : in_widths) length /= width;
            if (chain.size() < 2 * kLeast || dash_kind(std::move(in_widths)) != DashKind::dots) continue;
            for (std::size_t i = 0; i < chain.size(); ++i)
                if (lengths[i] > kFarLonger * width)
                    for (const std::size_t end : {chain[i], chain[i] ^ 1})
                        if (links_[end] != kNone) links_[std::exchange(links_[end], kNone)] = kNone;
        }
    }

    std::vector<InkedDash> dashes_;
    std::vector<std::size_t> links_;  // of each end
    std::vector<bool> hidden_;        // an end behind a mark
};

// Longer gaps are over what a row crosses.
double most_alike(const std::vector<double>& gaps) {
    constexpr double kLonger = 1.7;
    return kLonger * middle_length(gaps) + 1;
}

// Pieces that only happen to stand in a row have gaps of any length.
bool are_alike(const std::vector<double>& gaps) {
    constexpr double kMostLonger = 0.25;
    const double most = most_alike(gaps);
    const auto longer = std::count_if(gaps.begin(), gaps.end(), [&](double gap) { return gap > most; });
    return static_cast<double>(longer) <= kMostLonger * static_cast<double>(gaps.size());
}

// From the end of a row straight on, the first ink within `reach` of it.
std::optional<Point> met_from(const Image& ink, Point before, Point end, double width, double reach) {
    const double length = distance(before, end);
    if (!(length > 0)) return std::nullopt;
    for (double t = width / 2 + 1.5; t <= reach; t += 0.5) {
        const Point at{end.x + (end.x - before.x) * t / length, end.y + (end.y - before.y) * t / length};
        const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
        if (x < 0 || y < 0 || x >= ink.width || y >= ink.height) return std::nullopt;
        if (ink.row(y)[x] < 128) return at;
    }
    return std::nullopt;
}

// What a row stops close before it leads to: a gap there would be one that a finger feels. Gives how many ends that are.
int lead_on(const Image& ink, DashRow& row, double widest_gap) {
    constexpr double kReach = 1.6;
    const double reach = kReach * widest_gap + row.width;
    const auto from = met_from(ink, row.points[1], row.points.front(), row.width, reach);
    const auto to = met_from(ink, row.points[row.points.size() - 2], row.points.back(), row.width, reach);
    if (from) row.points.front() = *from;
    if (to) row.points.back() = *to;
    return (from ? 1 : 0) + (to ? 1 : 0);
}

}  // namespace

std::vector<DashRow> dash_rows_in(const Image& ink, const Image& picture, const DashLimits& limits,
                                  const std::vector<HidingMark>& marks) {
    if (limits.longest < 1) return {};
    const Components pieces =
        find_components(ink.width, ink.height, Joined::by_corners, [&](std::size_t i) { return ink.pixels[i] < 128; });
    const auto extents = pieces.extents();
    std::vector<std::vector<const Run*>> runs(pieces.count);
    for (const Run& run : pieces.runs)
        if (static_cast<double>(extents[run.component]) <= limits.longest) runs[run.component].push_back(&run);
    std::vector<InkedDash> dashes;
    for (std::uint32_t piece = 0; piece < pieces.count; ++piece) {
        if (runs[piece].empty()) continue;
        if (auto dash = inked_dash(runs[piece], limits.longest, limits.widest)) {
            dash->piece = piece;
            dash->hue = hue_of(picture, runs[piece]);
            dashes.push_back(*dash);
        }
    }
    if (dashes.size() < kLeast || dashes.size() > kMostDashes) return {};
    const Rows found(std::move(dashes), limits.gap, marks);
    std::vector<DashRow> rows;
    for (const std::vector<std::size_t>& chain : found.chains()) {
        const std::vector<double> gaps = found.gaps(chain);
        if (gaps.empty() || !are_alike(gaps)) continue;
        DashRow row;
        std::vector<double> widths, lengths;
        for (const std::size_t end : chain) {
            const InkedDash& dash = found.dash(end);
            row.points.push_back(dash.ends[end & 1]);
            row.points.push_back(dash.ends[1 - (end & 1)]);
            widths.push_back(dash.width);
            if (!found.is_cut(end)) lengths.push_back(dash.whole_length());
            for (const Run* run : runs[dash.piece]) row.ink.push_back(*run);
        }
        row.width = middle_length(widths);
        if (lengths.empty()) continue;
        std::sort(lengths.begin(), lengths.end());
        row.longest = lengths[lengths.size() * 17 / 20];
        for (double& length : lengths) length /= std::max(kThinnest, row.width);
        row.kind = dash_kind(std::move(lengths));
        row.leads = chain.size() < kLeast;
        if (row.leads && !is_straight(row)) continue;
        row.met = lead_on(ink, row, std::min(*std::max_element(gaps.begin(), gaps.end()), most_alike(gaps)));
        if (row.met < 2 && row.leads) continue;
        rows.push_back(std::move(row));
    }
    take_crossings(ink, pieces, limits, rows);
    return rows;
}

}  // namespace tactics
