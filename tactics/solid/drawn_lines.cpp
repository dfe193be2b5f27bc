// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/drawn_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace tactics {

namespace {

constexpr double kTouching = 1e-4;  // of the layout's extent

struct Side {
    Point from, to;
    LineClass line = LineClass::normal;
    bool twice = false;
};

// How many things lie one on the other below each.
std::vector<int> levels_of(const FlatLayout& layout, const Panels& panels, const std::vector<std::uint32_t>& thing,
                           double touching) {
    std::vector<int> level(thing.size(), 0);
    std::vector<const PlacedPanel*> kept;
    for (const PlacedPanel& placed : layout.panels)
        if (placed.handling == Handling::kept) kept.push_back(&placed);
    std::stable_sort(kept.begin(), kept.end(), [](const PlacedPanel* a, const PlacedPanel* b) { return a->height < b->height; });
    for (const PlacedPanel* over : kept)
        for (const PlacedPanel* under : kept) {
            const std::uint32_t top = panels.panels[over->panel].part, below = panels.panels[under->panel].part;
            if (top == below || under->height > over->height - touching || !boxes_meet(over->shape, under->shape, 0)) continue;
            if (meeting_of(over->shape, under->shape, touching) == ShapeMeeting::inside)
                level[top] = std::max(level[top], level[below] + 1);
        }
    // All of a thing is as thick as its highest part, if it lies on another
    // thing.
    std::vector<int> of_thing(thing.size(), 0);
    for (std::size_t part = 0; part < thing.size(); ++part) of_thing[thing[part]] = std::max(of_thing[thing[part]], level[part]);
    for (std::size_t part = 0; part < thing.size(); ++part) level[part] = std::min(level[part], of_thing[thing[part]]);
    return level;
}

// What of a side is not under any of those.
void take_visible(std::vector<Side>& sides, const Side& side, const std::vector<const PlacedPanel*>& over, double touching) {
    const double length = distance(side.from, side.to);
    if (!(length > touching)) return;
    std::vector<double> cuts = {0, 1};
    const auto at = [&](double share) {
        return Point{side.from.x + share * (side.to.x - side.from.x), side.from.y + share * (side.to.y - side.from.y)};
    };
    for (const PlacedPanel* one : over)
        for (const auto& ring : one->shape.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
                const double dx = side.to.x - side.from.x, dy = side.to.y - side.from.y, ex = b.x - a.x, ey = b.y - a.y;
                const double both = dx * ey - dy * ex;
                if (std::abs(both) < 1e-12 * length * std::hypot(ex, ey)) continue;
                const double t = ((a.x - side.from.x) * ey - (a.y - side.from.y) * ex) / both;
                const double s = ((a.x - side.from.x) * dy - (a.y - side.from.y) * dx) / both;
                if (t > 0 && t < 1 && s >= 0 && s <= 1) cuts.push_back(t);
            }
    std::sort(cuts.begin(), cuts.end());
    double begin = -1;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Point middle = at((cuts[i] + cuts[i + 1]) / 2);
        const bool hidden = std::any_of(over.begin(), over.end(), [&](const PlacedPanel* one) {
            return holds(one->shape, middle) && distance_to_border(one->shape, middle) > touching;
        });
        if (!hidden && begin < 0) begin = cuts[i];
        if ((hidden || i + 2 == cuts.size()) && begin >= 0) {
            const double end = hidden ? cuts[i] : 1;
            if ((end - begin) * length > touching) sides.push_back({at(begin), at(end), side.line, side.twice});
            begin = -1;
        }
    }
}

// Sides on the same straight line, put together where they overlap or touch.
std::vector<Side> merged(std::vector<Side> sides, double touching) {
    struct Course {
        Point origin, along;
        std::vector<std::array<double, 2>> spans;
        std::vector<Side> sides;
    };
    std::vector<Side> result;
    std::vector<char> done(sides.size(), 0);
    // By direction, so that only neighbours are compared.
    const auto angle = [](const Side& side) {
        double a = std::atan2(side.to.y - side.from.y, side.to.x - side.from.x);
        if (a < -1e-6) a += 3.14159265358979323846;
        if (a >= 3.14159265358979323846 - 1e-6) a -= 3.14159265358979323846;
        return a;
    };
    std::vector<std::size_t> order(sides.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angle(sides[a]) < angle(sides[b]); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (done[order[i]] != 0) continue;
        const Side& first = sides[order[i]];
        const double length = distance(first.from, first.to), turned = angle(first);
        const Point along{(first.to.x - first.from.x) / length, (first.to.y - first.from.y) / length};
        struct Span {
            double from, to;
            LineClass line;
            bool twice;
        };
        std::vector<Span> spans;
        for (std::size_t j = i; j < order.size() && angle(sides[order[j]]) <= turned + 1e-4; ++j) {
            const Side& other = sides[order[j]];
            if (done[order[j]] != 0) continue;
            const auto off = [&](Point at) {
                return std::abs((at.x - first.from.x) * along.y - (at.y - first.from.y) * along.x);
            };
            const auto on = [&](Point at) { return (at.x - first.from.x) * along.x + (at.y - first.from.y) * along.y; };
            if (off(other.from) > 2 * touching || off(other.to) > 2 * touching) continue;
            done[order[j]] = 1;
            spans.push_back(
                {std::min(on(other.from), on(other.to)), std::max(on(other.from), on(other.to)), other.line, other.twice});
        }
        std::stable_sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.from < b.from; });
        const auto take = [&](const Span& span) {
            const auto at = [&](double t) { return Point{first.from.x + t * along.x, first.from.y + t * along.y}; };
            result.push_back({at(span.from), at(span.to), span.line, span.twice});
        };
        std::vector<Span> open;
        for (const Span& span : spans) {
            const bool goes_on = !open.empty() && span.from <= open.back().to - touching;
            const bool same = !open.empty() && std::abs(span.from - open.back().to) <= touching &&
                              span.twice == open.back().twice && span.line == open.back().line;
            if (goes_on) {
                // A line that is there whole is no dashed one.
                if (span.to > open.back().to + touching && span.twice != open.back().twice) {
                    Span rest = span;
                    rest.from = open.back().to;
                    open.push_back(rest);
                    continue;
                }
                open.back().to = std::max(open.back().to, span.to);
                open.back().twice = open.back().twice && span.twice;
                open.back().line = std::max(open.back().line, span.line);
            } else if (same) {
                open.back().to = span.to;
            } else {
                open.push_back(span);
            }
        }
        for (const Span& span : open) take(span);
    }
    return result;
}

// Sides that meet end to end, two at a place, become one stroke.
std::vector<Stroke> joined(const std::vector<Side>& sides, double touching) {
    using Key = std::pair<long long, long long>;
    const double grain = 4 * touching;
    std::map<Key, int> numbers;
    std::vector<Point> places;
    const auto number = [&](Point at) {
        const Key key{std::llround(at.x / grain), std::llround(at.y / grain)};
        for (long long i = -1; i <= 1; ++i)
            for (long long j = -1; j <= 1; ++j)
                if (const auto found = numbers.find({key.first + i, key.second + j});
                    found != numbers.end() && distance(places[static_cast<std::size_t>(found->second)], at) <= grain)
                    return found->second;
        places.push_back(at);
        return numbers[key] = static_cast<int>(places.size()) - 1;
    };
    struct Link {
        int from, to;
    };
    std::vector<Link> links;
    std::vector<std::vector<std::size_t>> at;
    for (const Side& side : sides) {
        links.push_back({number(side.from), number(side.to)});
        at.resize(places.size());
        at[static_cast<std::size_t>(links.back().from)].push_back(links.size() - 1);
        at[static_cast<std::size_t>(links.back().to)].push_back(links.size() - 1);
    }
    const auto alike = [&](std::size_t a, std::size_t b) {
        return sides[a].line == sides[b].line && sides[a].twice == sides[b].twice;
    };
    const auto goes_on = [&](int place, std::size_t link) -> std::optional<std::size_t> {
        const auto& here = at[static_cast<std::size_t>(place)];
        if (here.size() != 2) return std::nullopt;
        const std::size_t other = here[0] == link ? here[1] : here[0];
        return other != link && alike(link, other) ? std::optional(other) : std::nullopt;
    };
    std::vector<char> done(links.size(), 0);
    std::vector<Stroke> strokes;
    const auto follow = [&](std::size_t link, int from) {
        Stroke stroke{.points = {places[static_cast<std::size_t>(from)]},
                      .closed = false,
                      .line = sides[link].line,
                      .strength = 0,
                      .role = sides[link].twice ? Role::dash : Role::line};
        int place = from;
        while (true) {
            done[link] = 1;
            place = links[link].from == place ? links[link].to : links[link].from;
            if (place == from) {
                stroke.closed = stroke.points.size() > 2;
                break;
            }
            stroke.points.push_back(places[static_cast<std::size_t>(place)]);
            const auto next = goes_on(place, link);
            if (!next || done[*next] != 0) break;
            link = *next;
        }
        strokes.push_back(std::move(stroke));
    };
    for (std::size_t link = 0; link < links.size(); ++link)
        for (const int end : {links[link].from, links[link].to})
            if (done[link] == 0 && !goes_on(end, link)) follow(link, end);
    for (std::size_t link = 0; link < links.size(); ++link)
        if (done[link] == 0) follow(link, links[link].from);
    std::erase_if(strokes, [](const Stroke& stroke) { return stroke.points.size() < 2; });
    return strokes;
}

}  // namespace

std::vector<Stroke> lines_of(const FlatLayout& layout, const std::vector<ModelPart>& parts, const Panels& panels,
                             const std::vector<std::uint32_t>& thing) {
    double extent = 0;
    for (const ModelPart& part : parts) extent = std::max(extent, extent_of(part));
    const double touching = kTouching * extent;
    const std::vector<int> level = levels_of(layout, panels, thing, touching);
    // Panels that are hinged elsewhere than they lie together show that side
    // twice.
    std::vector<int> place(panels.panels.size(), -1);
    for (std::size_t i = 0; i < layout.panels.size(); ++i) place[layout.panels[i].panel] = static_cast<int>(i);
    std::vector<std::vector<std::array<Point3, 2>>> twice(panels.panels.size());
    for (const Hinge& hinge : panels.hinges) {
        if (place[hinge.one] < 0 || place[hinge.other] < 0 || panels.panels[hinge.one].kind != PanelKind::side) continue;
        const PlacedPanel &one = layout.panels[static_cast<std::size_t>(place[hinge.one])],
                          &other = layout.panels[static_cast<std::size_t>(place[hinge.other])];
        const Point a = one.placement.of(hinge.one_from), b = one.placement.of(hinge.one_to);
        const Point c = other.placement.of(hinge.other_from), d = other.placement.of(hinge.other_to);
        if (distance(a, c) <= 20 * touching && distance(b, d) <= 20 * touching) continue;
        twice[hinge.one].push_back({hinge.one_from, hinge.one_to});
        twice[hinge.other].push_back({hinge.other_from, hinge.other_to});
    }
    std::vector<Side> sides;
    for (const PlacedPanel& placed : layout.panels) {
        std::vector<const PlacedPanel*> over;
        if (placed.handling == Handling::kept)
            for (const PlacedPanel& other : layout.panels)
                if (other.handling == Handling::kept && other.height > placed.height + touching &&
                    boxes_meet(other.shape, placed.shape, 0))
                    over.push_back(&other);
        const Panel& panel = panels.panels[placed.panel];
        const LineClass line = level[panel.part] > 0 ? LineClass::thick : LineClass::normal;
        for (std::size_t r = 0; r < panel.rings.size(); ++r)
            for (std::size_t i = 0; i < panel.rings[r].size(); ++i) {
                const std::size_t next = (i + 1) % panel.rings[r].size();
                const Point3 &a = panel.rings[r][i], &b = panel.rings[r][next];
                const bool again = std::any_of(twice[placed.panel].begin(), twice[placed.panel].end(), [&](const auto& seam) {
                    const auto same = [&](const Point3& p, const Point3& q) { return length_of(p - q) <= 20 * touching; };
                    return (same(a, seam[0]) && same(b, seam[1])) || (same(a, seam[1]) && same(b, seam[0]));
                });
                take_visible(sides, {placed.shape.rings[r][i], placed.shape.rings[r][next], line, again}, over, touching);
            }
    }
    std::vector<Side> bars;
    for (const PlacedBar& bar : layout.bars) {
        if (bar.handling == Handling::wedge || distance(bar.from, bar.to) <= touching) continue;
        std::vector<const PlacedPanel*> over;
        if (bar.handling == Handling::kept)
            for (const PlacedPanel& other : layout.panels)
                if (other.handling == Handling::kept && other.height > bar.height + touching) over.push_back(&other);
        take_visible(sides, {bar.from, bar.to, LineClass::normal, false}, over, touching);
    }
    return joined(merged(std::move(sides), touching), touching);
}

}  // namespace tactics
