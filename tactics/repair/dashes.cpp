// SPDX-License-Identifier: Apache-2.0
// Dashed lines as a finger reads them. A drawing keeps such a line whole until nothing about its way changes any more; then it is
// cut, and where others are near it a dash runs through: an end beside another line would be felt as a part of that.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "tactics/geometry/course.h"
#include "tactics/geometry/grid.h"
#include "tactics/geometry/line_styles.h"
#include "tactics/geometry/vectors.h"
#include "tactics/geometry/walk.h"
#include "tactics/repair/means.h"

namespace tactics {

namespace {

// Mm, as a finger meets them. Dashes of 6 to 10 mm with gaps of about half of that: a rule file after BANA 3.4.3.3, at second
// hand.
constexpr double kDash = 8, kShortestDash = 6, kShare = 0.5, kLongGap = 1.4;
constexpr double kBent = 1.05;  // on a curve it is less far straight across than along the line
constexpr double kDashStep = 0.5;
constexpr double kPageSteps = 0.03;    // mm: steps of the page
constexpr std::size_t kLeastDots = 3;  // of a dotted line
constexpr double kCorner = 0.866;      // cosine of 30 degrees, by which a line turns at a corner within kTurn, mm, on both sides
constexpr double kTurn = 1;
constexpr double kMostDashes = 2000;  // of a line; a page has room for far fewer
constexpr double kMostOfAll = 50000;  // of a drawing: several sheets full of them; lines beyond stay whole

struct DashSpan {
    double from, to;  // mm along the middle of the line
};

// Of a line's middle, so that a dash with its round ends and the white between two are as they should be.
struct Lengths {
    Lengths(const Medium& medium, double width)
        // On fixed dots a gap is an empty row at least.
        : least_gap(std::max(kBent * medium.gap + width, has_fixed_dots(medium) ? kTwoRows : 0.0)),
          gap(std::max(kShare * kDash + width, least_gap)),
          dash(kDash - width),
          shortest(std::max(kShortestDash, (least_gap - width) / kShare) - width) {}
    double least_gap, gap, dash, shortest;
};

// Their middle lines, if they do not cross.
bool are_nearer(const Stroke& a, const Stroke& b, double least) {
    if (distance(a.points[0], b.points[0]) > least + length_of(a) + length_of(b)) return false;
    for (const auto& [one, two] :
         {std::pair<const Stroke*, const Stroke*>{&a, &b}, std::pair<const Stroke*, const Stroke*>{&b, &a}})
        for (const Point& p : one->points)
            for (std::size_t k = 0; k + 1 < two->points.size(); ++k)
                if (distance_to_segment(p, two->points[k], two->points[k + 1]) < least) return true;
    return false;
}

// Wide marks on both legs of a sharp bend may be too near to each other: of two the later goes.
void leave_out_crowded(std::vector<Stroke>& marks, const Medium& medium) {
    if (marks.size() < 2) return;
    std::vector<Stroke> kept;
    for (Stroke& mark : marks) {
        const double width = width_of(mark.line, medium);
        const bool crowded = std::any_of(kept.begin(), kept.end(), [&](const Stroke& other) {
            return are_nearer(mark, other, medium.gap + kPageSteps / 2 + (width + width_of(other.line, medium)) / 2);
        });
        if (!crowded) kept.push_back(std::move(mark));
    }
    marks = std::move(kept);
}

Stroke dash_of(const Stroke& line, const DashSpan& dash) {
    return {part_of(line.points, line.closed, dash.from, dash.to), false, line.line, line.strength, Role::dash};
}

// Around a bend it is less far straight across than along the line: the longer of two dashes on its sides becomes shorter.
void part_at_bends(const Stroke& line, std::vector<DashSpan>& dashes, double least) {
    constexpr double kStep = 0.25, kLeast = 2;  // mm
    constexpr std::size_t kBack = 3;            // a sharp bend has a dash in it
    const auto length = [](const DashSpan& dash) { return dash.to - dash.from; };
    for (std::size_t i = 1; i < dashes.size(); ++i)
        for (std::size_t back = std::min(i, kBack); back > 0; --back) {
            DashSpan &one = dashes[i - back], &next = dashes[i];
            while (std::max(length(one), length(next)) > kLeast && are_nearer(dash_of(line, one), dash_of(line, next), least)) {
                if (length(one) > length(next))
                    one.to -= kStep;
                else
                    next.from += kStep;
            }
        }
}

class Dashing {
public:
    Dashing(const Drawing& drawing, const Medium& medium)
        : drawing_(drawing),
          medium_(medium),
          page_(page_of(drawing, medium)),
          geometry_(page_),
          grid_(boxes(), page_.width, page_.height),
          chain_of_(drawing.strokes.size(), geometry_.chains.size()),
          thick_beside_normal_(has_dashed(LineClass::thick) && has_dashed(LineClass::normal)) {
        for (std::size_t i = 0; i < geometry_.chains.size(); ++i)
            if (!geometry_.chains[i].ring) chain_of_[geometry_.chains[i].owner] = i;
    }

    // The line itself if there is no room for two dashes.
    std::vector<Stroke> cut(std::size_t number) {
        if (std::optional<std::vector<Stroke>> marks = with_dots(number)) return *std::move(marks);
        const Stroke& line = drawing_.strokes[number];
        const double length = length_of(line);
        const Lengths lengths(medium_, page_.strokes[number].width);
        const double most = length / lengths.dash;
        if (length < 2 * lengths.shortest + lengths.gap || most > std::min(kMostDashes, left_)) return {line};
        left_ -= most;
        std::vector<DashSpan> dashes = whole_parts(number, length, lengths);
        if (line.closed) {
            if (dashes.empty()) dashes.push_back({0, lengths.dash});
            dashes.push_back({dashes.front().from + length, dashes.front().to + length});
        } else {
            if (dashes.empty() || dashes.front().from > 0)
                dashes.insert(dashes.begin(), {0, std::min(lengths.dash, dashes.empty() ? length : dashes.front().from)});
            if (dashes.back().to < length) dashes.push_back({std::max(length - lengths.dash, dashes.back().to), length});
        }
        dashes = filled(dashes, lengths);
        if (line.closed && dashes.size() > 1) {
            // The first stands at both ends and may have grown at either.
            dashes.front().from = std::min(dashes.front().from, dashes.back().from - length);
            dashes.pop_back();
            if (dashes.front().from < 0) dashes.front() = {dashes.front().from + length, dashes.front().to + length};
        }
        if (dashes.size() < 2) return {line};
        part_at_bends(line, dashes, page_.strokes[number].width + medium_.gap + kPageSteps);
        std::vector<Stroke> strokes;
        for (const DashSpan& dash : dashes)
            if (Stroke stroke = dash_of(line, dash); stroke.points.size() > 1) strokes.push_back(std::move(stroke));
        if (line.line == LineClass::thick) leave_out_crowded(strokes, medium_);
        return strokes;
    }

private:
    bool has_dashed(LineClass line) const {
        return std::any_of(drawing_.strokes.begin(), drawing_.strokes.end(),
                           [&](const Stroke& stroke) { return stroke.role == Role::dash && stroke.line == line; });
    }

    // Dots are left out where others are near: their gaps say nothing, and the line goes on behind. So does what is left of a
    // dotted line between two things. Nothing if it has no dots, or too few of a longer one would be left. Where thick lines are
    // as thin as others, dots say that thick dashes are not those of others.
    std::optional<std::vector<Stroke>> with_dots(std::size_t number) {
        const Stroke& line = drawing_.strokes[number];
        const bool thick = line.line == LineClass::thick && thick_beside_normal_;
        const LineStyle style = line_style(line.role == Role::dots ? kDottedStyle
                                           : thick                 ? kThickDashedStyle
                                                                   : kDashedStyle,
                                           medium_);
        const std::size_t chain = chain_of_[number];
        if (std::find(style.marks.begin(), style.marks.end(), 0) == style.marks.end() || chain == geometry_.chains.size())
            return std::nullopt;
        if (length_of(line) / style.gap > std::min(kMostDashes, left_)) return std::nullopt;
        Medium roomy = medium_;
        roomy.gap += kPageSteps;  // or dots that have just enough room between them would be crowded on the page
        std::vector<Stroke> marks = in_style(line.points, line.closed, style, roomy);
        const std::size_t all = marks.size();
        const std::vector<Stroke> joined = joints(line, chain);
        const double gap = medium_.gap + kPageSteps, from_joint = gap + (medium_.line + width_of(style.line, medium_)) / 2;
        std::erase_if(marks, [&](const Stroke& mark) {
            return std::any_of(mark.points.begin(), mark.points.end(),
                               [&](Point p) { return is_near(geometry_.chains[chain], chain, p, gap); }) ||
                   std::any_of(joined.begin(), joined.end(),
                               [&](const Stroke& joint) { return are_nearer(mark, joint, from_joint); });
        });
        const bool rest = line.role == Role::dots && all <= kLeastDots;
        if (rest && marks.empty() && length_of(line) >= kShortestDash && !goes_on(number, style.gap) && is_clear(number)) {
            // The link of two things that are close to each other would be lost.
            Stroke whole = line;
            whole.line = LineClass::normal;
            return std::vector<Stroke>{std::move(whole)};
        }
        if (!rest && marks.size() < std::max(kLeastDots, all / 3)) return std::nullopt;
        left_ -= static_cast<double>(all);
        leave_out_crowded(marks, medium_);
        marks.insert(marks.end(), joined.begin(), joined.end());
        for (Stroke& mark : marks) mark.strength = line.strength;
        return marks;
    }

    // Behind what it stops at, at both ends, there is another dotted line in its direction.
    bool goes_on(std::size_t number, double gap) const {
        constexpr double kSameWay = 0.8;  // cosine
        const std::vector<Point>& own = drawing_.strokes[number].points;
        const double far = static_cast<double>(kLeastDots) * gap;
        const auto goes_on_from = [&](Point end, Point other_end) {
            for (std::size_t i = 0; i < drawing_.strokes.size(); ++i) {
                const Stroke& other = drawing_.strokes[i];
                if (i == number || other.role != Role::dots || other.points.empty()) continue;
                for (const Point at : {other.points.front(), other.points.back()})
                    if (distance(end, at) <= far && cosine(end - other_end, at - end) >= kSameWay) return true;
            }
            return false;
        };
        return goes_on_from(own.front(), own.back()) && goes_on_from(own.back(), own.front());
    }

    // It leaves what it ends at at no small angle, and nothing else is beside it.
    bool is_clear(std::size_t number) const {
        constexpr double kSlope = 0.5;  // sine of that angle
        const std::size_t own = chain_of_[number];
        const Chain& chain = geometry_.chains[own];
        const double length = length_of(drawing_.strokes[number]);
        for (double along = kDashStep; along < length; along += kDashStep) {
            const double middles = std::min(kSlope * std::min(along, length - along), medium_.gap + medium_.line);
            if (is_near(chain, own, geometry_.point_at({own, along}), middles - chain.half_width - medium_.line / 2, true))
                return false;
        }
        return true;
    }

    // What met only on a line of dots would be left with a gap too small to be felt as one.
    std::vector<Stroke> joints(const Stroke& line, std::size_t chain) const {
        const std::vector<PageGeometry::Meets>& all = geometry_.contacts_of[chain];
        const auto other = [&](const PageGeometry::Meets& meets) {
            const Contact& contact = geometry_.contacts[meets.contact];
            return meets.turned ? contact.one : contact.other;
        };
        std::vector<Stroke> strokes;
        for (std::size_t i = 0; i + 1 < all.size(); ++i) {
            const Station a = other(all[i]), b = other(all[i + 1]);
            if (a.chain == chain || b.chain == chain) continue;
            const Point from = geometry_.point_at(a), to = geometry_.point_at(b);
            const double least =
                medium_.gap + kPageSteps + geometry_.chains[a.chain].half_width + geometry_.chains[b.chain].half_width;
            if (distance(from, to) >= least) continue;
            if (a.chain == b.chain && PageGeometry::way(geometry_.chains[a.chain], a.along, b.along) < 2 * least) continue;
            Stroke joint{{from}, false, LineClass::normal, 0, Role::dash};
            for (const Point& p : part_of(line.points, line.closed, all[i].along, all[i + 1].along)) joint.points.push_back(p);
            joint.points.push_back(to);
            strokes.push_back(std::move(joint));
        }
        return strokes;
    }

    std::vector<Box> boxes() const {
        std::vector<Box> all;
        for (std::size_t piece = 0; piece < geometry_.pieces.size(); ++piece) all.push_back(geometry_.box_of_piece(piece, 0));
        return all;
    }

    // `but_heads`: what it ends in may be the head of an arrow.
    bool is_near(const Chain& own, std::size_t own_number, Point at, double gap, bool but_heads = false) const {
        const double reach = own.half_width + gap + medium_.thick_line / 2;
        const Box box{at.x - reach, at.y - reach, at.x + reach, at.y + reach};
        return grid_.any_near(box, [&](std::size_t piece) {
            const Piece& other = geometry_.pieces[piece];
            if (other.chain == own_number || (but_heads && is_head(geometry_.chains[other.chain]))) return false;
            const double least = gap + own.half_width + geometry_.chains[other.chain].half_width;
            return distance(nearest_on(other.line, at), at) < least;
        });
    }

    bool is_head(const Chain& chain) const { return chain.ring && drawing_.areas[chain.owner].role == Role::arrow; }

    // Where others are near: a dash each.
    std::vector<DashSpan> held(std::size_t number, double length) const {
        std::vector<DashSpan> spans;
        const std::size_t chain = chain_of_[number];
        if (chain == geometry_.chains.size()) return spans;
        const Chain& own = geometry_.chains[chain];
        const auto steps = static_cast<std::size_t>(std::ceil(length / kDashStep));
        for (std::size_t i = 0; i <= steps; ++i) {
            const double along = std::min(static_cast<double>(i) * kDashStep, length);
            if (!is_near(own, chain, geometry_.point_at({chain, along}), kBent * medium_.gap)) continue;
            const DashSpan span{std::max(0.0, along - kDashStep), std::min(length, along + kDashStep)};
            if (!spans.empty() && spans.back().to >= span.from)
                spans.back().to = span.to;
            else
                spans.push_back(span);
        }
        return spans;
    }

    // Where a dash goes round a corner: ends on both sides of it would be too close to each other, and the corner would not be
    // felt. Of corners so close that there would be no gap between their dashes, two have one, and a third has none.
    static std::vector<DashSpan> corners(const Stroke& line, const Lengths& lengths) {
        const std::vector<Point>& points = line.points;
        const std::size_t n = points.size();
        std::vector<DashSpan> spans;
        double along = 0;
        for (std::size_t i = line.closed ? 0 : 1; i + (line.closed ? 0 : 1) < n; ++i) {
            if (i > 0) along += distance(points[i - 1], points[i]);
            if (!is_corner(line, i)) continue;
            if (!spans.empty() && along - spans.back().to < lengths.shortest + lengths.least_gap &&
                along - spans.back().from < kDash)
                spans.back().to = along;  // a round one, or one dash round both
            else if (spans.empty() || along - spans.back().to >= lengths.shortest + lengths.least_gap)
                spans.push_back({along, along});
        }
        return spans;
    }

    static bool is_corner(const Stroke& line, std::size_t i) {
        const std::vector<Point>& points = line.points;
        const std::size_t n = points.size(), most = line.closed ? n - 1 : n - 1 - i, most_back = line.closed ? n - 1 : i;
        std::size_t on = 1, back = 1;
        while (on < most && distance(points[i], points[(i + on) % n]) < kTurn) ++on;
        while (back < most_back && distance(points[i], points[(i + n - back) % n]) < kTurn) ++back;
        const Point a = points[(i + n - back) % n], b = points[i], c = points[(i + on) % n];
        return cosine(b - a, c - b) < kCorner;
    }

    // What must not have a gap, in its order, as long as a dash at least, and one where two meet.
    std::vector<DashSpan> whole_parts(std::size_t number, double length, const Lengths& lengths) const {
        const Stroke& line = drawing_.strokes[number];
        std::vector<DashSpan> spans = held(number, length);
        for (const DashSpan& corner : corners(line, lengths)) spans.push_back(corner);
        std::sort(spans.begin(), spans.end(), [](const DashSpan& a, const DashSpan& b) { return a.from < b.from; });
        std::vector<DashSpan> dashes;
        for (DashSpan span : spans) {
            const double more = std::max(0.0, lengths.shortest - (span.to - span.from)) / 2;
            span = {span.from - more, span.to + more};
            if (!line.closed) {
                const double in = std::max(0.0, -span.from) - std::max(0.0, span.to - length);
                span = {span.from + in, span.to + in};
            }
            if (!dashes.empty() && dashes.back().to >= span.from)
                dashes.back().to = std::max(dashes.back().to, span.to);
            else
                dashes.push_back(span);
        }
        return dashes;
    }

    // Dashes between those that are given, as even as may be; where there is no room for a gap two become one.
    static std::vector<DashSpan> filled(const std::vector<DashSpan>& given, const Lengths& usual) {
        std::vector<DashSpan> all{given.front()};
        for (std::size_t i = 1; i < given.size(); ++i) {
            const double from = all.back().to, room = given[i].from - from;
            if (room < usual.least_gap) {
                all.back().to = std::max(from, given[i].to);
                continue;
            }
            const double most = std::floor((room - usual.least_gap) / (usual.shortest + usual.least_gap));
            const double count = std::clamp(std::round((room - usual.gap) / (usual.dash + usual.gap)), 0.0, most);
            if (count == 0) {
                // One gap, up to the longest that is still about half a dash; the rest goes to the dashes on both sides.
                const double more = std::max(0.0, room - kLongGap * usual.gap) / 2;
                all.back().to += more;
                all.push_back({given[i].from - more, given[i].to});
                continue;
            }
            const double stretch = room / (count * usual.dash + (count + 1) * usual.gap);
            const double gap = std::max(usual.least_gap, usual.gap * stretch), dash = (room - (count + 1) * gap) / count;
            for (double k = 0; k < count; ++k) all.push_back({from + gap + k * (dash + gap), from + (k + 1) * (dash + gap)});
            all.push_back(given[i]);
        }
        return all;
    }

    const Drawing& drawing_;
    const Medium& medium_;
    const Page page_;
    const PageGeometry geometry_;
    const Grid grid_;
    std::vector<std::size_t> chain_of_;  // of each line; that there is none: the number of chains
    const bool thick_beside_normal_;     // of dashed lines
    double left_ = kMostOfAll;           // dashes
};

}  // namespace

bool cut_dashes(Drawing& drawing, const Medium& medium) {
    const auto is_dashed = [](const Stroke& stroke) {
        return (stroke.role == Role::dash || stroke.role == Role::dots) && stroke.points.size() > 1;
    };
    if (std::none_of(drawing.strokes.begin(), drawing.strokes.end(), is_dashed)) return false;
    Dashing dashing(drawing, medium);
    std::vector<Stroke> strokes;
    bool any = false;
    for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
        if (!is_dashed(drawing.strokes[i])) {
            strokes.push_back(drawing.strokes[i]);
            continue;
        }
        std::vector<Stroke> dashes = dashing.cut(i);
        any = any || dashes.size() > 1;
        for (Stroke& dash : dashes) dash.role = Role::dash;
        std::move(dashes.begin(), dashes.end(), std::back_inserter(strokes));
    }
    drawing.strokes = std::move(strokes);
    return any;
}

}  // namespace tactics
