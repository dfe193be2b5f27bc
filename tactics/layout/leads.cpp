// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/leads.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "tactics/geometry/course.h"
#include "tactics/geometry/distance.h"

namespace tactics {

namespace {

constexpr std::size_t kBlock = 32;     // sides; a curve of a plot has thousands
constexpr double kLeadStep = 0.5;      // mm between the examined places of a lead line
constexpr double kPiece = 10;          // mm of a lead line whose surroundings are looked up at a time
constexpr double kOn = kLeadStep / 2;  // mm from a middle line to one that crosses it, at such a place
// As in the rule gap (rules/narrow.h): there is no gap where the path through ink is at most four times as long. Slightly less
// here.
constexpr double kBend = 3.5;
// What files leave of a place: hundredths, at both ends.
constexpr double kLeadRounding = 0.02;

constexpr double kAlong = 1.5;     // mm: nearer than a finger tells two lines apart, and farther than two lines cross in
constexpr double kSameWay = 0.98;  // cosine of 11 degrees

// An alternative end along the same line if the nearest place is hemmed in: no farther than a fingertip feels at once.
constexpr double kAside = 2;  // mm

Point point_at(const std::vector<Point>& points, double along) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double side = distance(points[i - 1], points[i]);
        if (along <= side && side > 0) {
            const double t = along / side;
            return {points[i - 1].x + t * (points[i].x - points[i - 1].x), points[i - 1].y + t * (points[i].y - points[i - 1].y)};
        }
        along -= side;
    }
    return points.back();
}

double side_of(Point p, Point a, Point b) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

// Of a lead line: how far a side runs the same way on it or right beside it, where a finger takes both for one line.
double length_along(Point a, Point b, Point from, Point to) {
    const double length = distance(from, to);
    if (!(length > 0)) return 0;
    const auto along = [&](Point p) { return ((p.x - from.x) * (to.x - from.x) + (p.y - from.y) * (to.y - from.y)) / length; };
    const double one = along(a), other = along(b);
    const double first = std::max(0.0, std::min(one, other)), last = std::min(length, std::max(one, other));
    if (!(first < last) || std::abs(other - one) < kSameWay * distance(a, b)) return 0;
    const auto apart = [&](double at) {
        const double t = (at - one) / (other - one);
        return std::abs(side_of({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, from, to)) / length;
    };
    return std::max(apart(first), apart(last)) <= kAlong ? last - first : 0;
}

// All of the lead line from all of that side.
bool is_farther(const Lead& lead, Point a, Point b, double near) {
    if (!meet(box_of(Segment{a, b}, 0), box_of(Segment{lead.from, lead.to}, near))) return true;
    const bool crosses = side_of(a, lead.from, lead.to) * side_of(b, lead.from, lead.to) <= 0 &&
                         side_of(lead.from, a, b) * side_of(lead.to, a, b) <= 0;
    return !crosses && distance_to_segment(a, lead.from, lead.to) >= near && distance_to_segment(b, lead.from, lead.to) >= near &&
           distance_to_segment(lead.from, a, b) >= near && distance_to_segment(lead.to, a, b) >= near;
}

Box box_of_rings(const std::vector<std::vector<Point>>& rings) {
    Box box = kNothing;
    for (const auto& ring : rings)
        for (const Point& p : ring) box.take(p);
    return box;
}

bool lies_in(Point p, const std::vector<std::vector<Point>>& rings) {
    bool inside = false;
    for (const auto& ring : rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            if (ray_meets(p, ring[j], ring[i])) inside = !inside;
    return inside;
}

}  // namespace

Leads::Leads(const Page& page, double width, double clear) : half_(width / 2), clear_(clear + kLeadRounding) {
    for (const PageStroke& stroke : page.strokes) add_chain(stroke.points, stroke.closed, stroke.width / 2);
    for (const Area& area : page.areas) {
        for (const auto& ring : area.rings) add_chain(ring, true, 0);
        areas_.push_back({area.rings, box_of_rings(area.rings)});
    }
    if (page.picture) {  // dots are all over it
        const Rect& place = page.picture->place;
        const std::vector<Point> edge{{place.left, place.top},
                                      {place.left + place.width, place.top},
                                      {place.left + place.width, place.top + place.height},
                                      {place.left, place.top + place.height}};
        add_chain(edge, true, 0);
        areas_.push_back({{edge}, box_of_rings({edge})});
    }
    std::vector<Box> boxes;
    boxes.reserve(chains_.size());
    for (const Chain& chain : chains_) boxes.push_back(chain.box);
    in_grid_ = chains_.size();
    grid_ = Grid(std::move(boxes), page.width, page.height);
}

void Leads::add_chain(const std::vector<Point>& points, bool closed, double half_width) {
    if (points.empty()) return;
    Chain chain{points, closed, half_width, 0, grown(box_of(points), half_width), {}};
    if (closed) chain.points.push_back(points[0]);
    for (std::size_t i = 0; i < chain.points.size(); ++i) {
        const Point &p = chain.points[i], &before = chain.points[i > 0 ? i - 1 : 0];
        if (i % kBlock == 0) chain.blocks.push_back({i, i, chain.length, box_of(Segment{before, before}, 0)});
        Block& block = chain.blocks.back();
        block.end = i + 1;
        block.box.take(p);
        if (i > 0) chain.length += distance(before, p);
    }
    chains_.push_back(std::move(chain));
}

void Leads::add(const Lead& lead) { add_chain({lead.from, lead.to}, false, half_); }

// Each once, in the order in which they came to the page, which decides between two that are as near.
std::vector<std::size_t> Leads::chains_near(const Box& box) const {
    std::vector<std::size_t> near;
    grid_.any_near(box, [&](std::size_t chain) {
        near.push_back(chain);
        return false;
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (std::size_t chain = in_grid_; chain < chains_.size(); ++chain)
        if (meet(chains_[chain].box, box)) near.push_back(chain);
    return near;
}

void Leads::look_for_end(std::size_t number, Point thing, End& best) const {
    const Chain& chain = chains_[number];
    if (!grown(chain.box, best.apart).holds(thing)) return;
    for (const Block& block : chain.blocks) {
        const double far = best.apart + chain.half_width;
        if (!meet(block.box, box_of(Segment{thing, thing}, far))) continue;
        double way = block.along;
        for (std::size_t i = block.first; i < block.end; ++i) {
            const Point before = chain.points[i > 0 ? i - 1 : 0], near = nearest_on_segment(thing, before, chain.points[i]);
            if (const double apart = distance(near, thing) - chain.half_width; apart < best.apart)
                best = {apart, &chain, way + distance(before, near)};
            way += distance(before, chain.points[i]);
        }
    }
}

std::vector<Point> Leads::ends_for(Point thing) const {
    const bool black = std::any_of(areas_.begin(), areas_.end(),
                                   [&](const InkedArea& area) { return area.box.holds(thing) && lies_in(thing, area.rings); });
    End best{half_ + clear_, nullptr, 0};
    for (const std::size_t chain : chains_near(box_of(Segment{thing, thing}, best.apart))) look_for_end(chain, thing, best);
    // In ink, however far its edge is.
    if (black && best.chain == nullptr) {
        best.apart = 1e9;
        for (std::size_t chain = 0; chain < chains_.size(); ++chain) look_for_end(chain, thing, best);
    }
    if (best.chain == nullptr) return {thing};
    std::vector<Point> ends;
    for (const double aside : {0.0, kAside, -kAside, 2 * kAside, -2 * kAside})
        if (best.along + aside >= 0 && best.along + aside <= best.chain->length)
            ends.push_back(point_at(best.chain->points, best.along + aside));
    return ends;
}

bool Leads::is_clear(const Lead& lead, bool across, bool leads) const {
    if (in_way_ < in_grid_ && !is_clear_of(chains_[in_way_], lead, across)) return false;
    // On a full page the first piece of the line meets something, so only the chains near it are examined.
    const double length = distance(lead.from, lead.to);
    const int pieces = 1 + static_cast<int>(length / kPiece);
    std::unordered_set<std::size_t> clear{in_way_};
    const auto meets = [&](std::size_t chain) {
        if (is_clear_of(chains_[chain], lead, across)) return false;
        in_way_ = chain;
        return true;
    };
    const auto on_way = [&](int piece) {
        const double t = static_cast<double>(piece) / pieces;
        return Point{lead.from.x + t * (lead.to.x - lead.from.x), lead.from.y + t * (lead.to.y - lead.from.y)};
    };
    for (int piece = 0; piece < pieces; ++piece) {
        const Box box = box_of(Segment{on_way(piece), on_way(piece + 1)}, half_ + clear_ + kLeadRounding);
        if (grid_.any_near(box, [&](std::size_t chain) { return clear.insert(chain).second && meets(chain); })) return false;
    }
    // Where two lead lines meet, a finger does not know which of them goes on.
    for (std::size_t chain = in_grid_; chain < chains_.size(); ++chain) {
        const std::vector<Point>& other = chains_[chain].points;
        if (leads ? !is_clear_of(chains_[chain], lead, across)
                  : !is_farther(lead, other.front(), other.back(), 2 * half_ + clear_))
            return false;
    }
    return true;
}

bool Leads::has_ink_near(Point place, double within) const {
    End best{within, nullptr, 0};
    for (const std::size_t chain : chains_near(box_of(Segment{place, place}, within))) look_for_end(chain, place, best);
    return best.chain != nullptr;
}

std::size_t Leads::crossings(const Lead& lead) const {
    const double length = distance(lead.from, lead.to);
    if (!(length > 0)) return 0;
    const Box box = box_of(Segment{lead.from, lead.to}, kAlong);
    std::size_t count = 0;
    for (const std::size_t number : chains_near(box)) {
        const Chain& chain = chains_[number];
        const std::size_t times = number < in_grid_ ? 1 : 4, before = count;
        const double end = std::max(0.0, 1 - (chain.half_width + half_ + kOn) / length);
        const Point to{lead.from.x + end * (lead.to.x - lead.from.x), lead.from.y + end * (lead.to.y - lead.from.y)};
        double along = 0;
        for (const Block& block : chain.blocks) {
            if (!meet(block.box, box)) continue;
            for (std::size_t i = std::max<std::size_t>(1, block.first); i < block.end; ++i) {
                const Point a = chain.points[i - 1], b = chain.points[i];
                // A corner belongs to one of its sides.
                if ((side_of(a, lead.from, to) > 0) != (side_of(b, lead.from, to) > 0) &&
                    (side_of(lead.from, a, b) > 0) != (side_of(to, a, b) > 0))
                    count += times;
                along += length_along(a, b, lead.from, to);
            }
        }
        const auto touches = [&](Point p) { return distance_to_segment(p, lead.from, to) <= chain.half_width + half_; };
        const bool through_end = !chain.closed && (touches(chain.points.front()) || touches(chain.points.back()));
        if (count == before && (through_end || along > kAlong)) count += times;
    }
    return count;
}

bool Leads::is_clear_of(const Chain& chain, const Lead& lead, bool across) const {
    const double reach = half_ + clear_, near = chain.half_width + reach;
    const Segment course{lead.from, lead.to};
    if (!meet(box_of(course, 0), grown(chain.box, reach))) return true;
    struct Close {
        double along_lead, along_chain, apart;
    };
    std::vector<Close> close;
    const double length = distance(lead.from, lead.to);
    const int steps = 1 + static_cast<int>(length / kLeadStep);
    const double ink = chain.half_width + half_;
    const Box around = box_of(course, near);
    for (const Block& block : chain.blocks) {
        if (!meet(block.box, around)) continue;
        double along = block.along;
        for (std::size_t i = block.first; i < block.end; ++i) {
            const Point a = chain.points[i > 0 ? i - 1 : 0], b = chain.points[i];
            const double side = distance(a, b);
            if (!is_farther(lead, a, b, near)) {
                // Only so far along may it be near this side.
                const auto share = [&](Point p) {
                    return ((p.x - lead.from.x) * (lead.to.x - lead.from.x) + (p.y - lead.from.y) * (lead.to.y - lead.from.y)) /
                           (length * length);
                };
                const double one = share(a), other = share(b), more = near / length;
                const int first = static_cast<int>(std::floor(std::clamp(std::min(one, other) - more, 0.0, 1.0) * steps));
                const int last = static_cast<int>(std::ceil(std::clamp(std::max(one, other) + more, 0.0, 1.0) * steps));
                for (int k = first; k <= last; ++k) {
                    const double t = static_cast<double>(k) / steps;
                    const Point p{lead.from.x + t * (lead.to.x - lead.from.x), lead.from.y + t * (lead.to.y - lead.from.y)};
                    const Point q = nearest_on_segment(p, a, b);
                    const double apart = distance(p, q);
                    if (!across && apart <= ink && t * length < length - 2 * ink - kLeadStep) return false;
                    if (apart < near) close.push_back({t * length, along + distance(a, q), apart});
                }
            }
            along += side;
        }
    }
    std::vector<Close> meetings;
    for (const Close& place : close)
        if (place.apart <= kOn) meetings.push_back(place);  // middle on middle: before that ink of a flat angle meets, too
    return std::all_of(close.begin(), close.end(), [&](const Close& place) {
        return std::any_of(meetings.begin(), meetings.end(), [&](const Close& meeting) {
            double way = std::abs(place.along_chain - meeting.along_chain);
            if (chain.closed) way = std::min(way, chain.length - way);
            return way + std::abs(place.along_lead - meeting.along_lead) <= kBend * place.apart + kOn;
        });
    });
}

}  // namespace tactics
