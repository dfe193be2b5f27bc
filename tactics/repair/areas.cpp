// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/repair/means.h"
#include "tactics/rules/coverage.h"

namespace tactics {

namespace {

// A shape whose sides are shorter may not be recognised (APH guide): its outline would not be either.
constexpr double kRecognised = 12.7;  // mm

double extent_of(const Area& area) {
    std::vector<Point> points;
    for (const auto& ring : area.rings) points.insert(points.end(), ring.begin(), ring.end());
    return greatest_extent(points);
}

constexpr int kPushes = 8;        // rounds in which small areas are pushed apart
constexpr double kPushed = 0.05;  // mm that they are pushed farther than the rule asks
constexpr double kRim = 0.15;     // mm that a line around an area may be off its edge
constexpr double kNoticed = 0.1;  // mm: less is not worth a word

bool is_small(const Area& area) { return area.texture == 0 && !area.rings.empty() && extent_of(area) < kRecognised; }

double size_of(const Area& area) {  // square mm, holes taken off by the even-odd rule where they lie in their ring
    double most = 0, sum = 0;
    for (const auto& ring : area.rings) {
        double doubled = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            doubled += a.x * b.y - b.x * a.y;
        }
        most = std::max(most, std::abs(doubled) / 2);
        sum += std::abs(doubled) / 2;
    }
    return std::max(0.0, 2 * most - sum);
}

// As points of a chart are; an arrow head belongs to its line.
bool is_compact(const Area& area, double extent) {
    constexpr double kCompact = 0.4;  // of the square of its extent: a disc has 0.79, a square 0.5, a sliver nothing
    return area.role != Role::arrow && is_small(area) && extent > 0 && size_of(area) >= kCompact * extent * extent;
}

// What has points of one size, as a chart of one series has: the extents of its compact small areas, 0 for other areas. Empty
// where they differ, as size may tell things apart, and where there are fewer than three, which may be parts of a thing.
std::vector<double> extents_of_points(const Drawing& drawing, double least, double most) {
    constexpr double kSame = 1.1;
    std::vector<double> extents;
    std::size_t count = 0;
    double smallest = most, largest = 0;
    for (const Area& area : drawing.areas) {
        const double extent = is_small(area) ? extent_of(area) : 0;
        const bool point = extent >= least && extent < most && is_compact(area, extent);
        extents.push_back(point ? extent : 0);
        if (!point) continue;
        ++count;
        smallest = std::min(smallest, extent);
        largest = std::max(largest, extent);
    }
    if (count < 3 || largest > kSame * smallest) extents.clear();
    return extents;
}

void scale_about_middle(Area& area, double by) {
    const Box box = box_of(area.rings[0]);
    const Point middle{(box.left + box.right) / 2, (box.top + box.bottom) / 2};
    for (auto& ring : area.rings)
        for (Point& p : ring) p = {middle.x + by * (p.x - middle.x), middle.y + by * (p.y - middle.y)};
}

// To this much less than the limit, in percent of the paper; then it is measured again.
constexpr double kInkToSpare = 1;

Point first_point(const Area& area) {
    for (const auto& ring : area.rings)
        if (!ring.empty()) return ring[0];
    return {};
}

// Its place is left empty, so that the others keep their numbers.
Mend to_outline(Drawing& drawing, std::size_t index) {
    Area area = std::move(drawing.areas[index]);
    drawing.areas[index].rings.clear();
    double length = 0;
    const Point at = first_point(area);
    for (auto& ring : area.rings) {
        length += length_of(Stroke{ring, true});
        if (ring.size() >= 3) drawing.strokes.push_back({std::move(ring), true, LineClass::normal, 0, area.role});
    }
    return {Mend::Kind::outlined, at, length};
}

// The closest place between each two areas, by their numbers, the lower first.
std::map<std::pair<std::size_t, std::size_t>, NearPair> close_areas(Seen& seen) {
    std::map<std::pair<std::size_t, std::size_t>, NearPair> closest;
    for (std::size_t i = 0; i < seen.near.size(); ++i) {
        const Chain *one = &seen.geometry.chains[seen.geometry.pieces[seen.near[i].one].chain],
                    *other = &seen.geometry.chains[seen.geometry.pieces[seen.near[i].other].chain];
        if (!one->ring || !other->ring || one->owner == other->owner || !seen.near.is_too_close(i)) continue;
        NearPair pair = seen.near.pair(i);
        if (one->owner > other->owner) {
            std::swap(one, other);
            std::swap(pair.at, pair.other_at);
        }
        const auto [known, fresh] = closest.try_emplace({one->owner, other->owner}, pair);
        if (!fresh && pair.lacks > known->second.lacks) known->second = pair;
    }
    return closest;
}

// How far each area is from its place; no farther than a fingertip can tell, and within the drawing.
class Shifts {
public:
    explicit Shifts(const Drawing& drawing) : drawing_(drawing), by_(drawing.areas.size()) {
        for (const Area& area : drawing.areas) {
            small_.push_back(is_small(area));
            boxes_.push_back(area.rings.empty() ? kNothing : box_of(area.rings[0]));
        }
    }
    bool is_small_at(std::size_t i) const { return small_[i]; }
    double size_at(std::size_t i) const { return std::hypot(by_[i].x, by_[i].y); }

    void push(std::size_t i, Point way) {
        Point by{by_[i].x + way.x, by_[i].y + way.y};
        if (const double size = std::hypot(by.x, by.y); size > kFarthestMove)
            by = {by.x / size * kFarthestMove, by.y / size * kFarthestMove};
        const Box& box = boxes_[i];
        by_[i] = {std::clamp(by.x, std::min(0.0, -box.left), std::max(0.0, drawing_.width - box.right)),
                  std::clamp(by.y, std::min(0.0, -box.top), std::max(0.0, drawing_.height - box.bottom))};
    }
    Drawing shifted() const {
        Drawing result = drawing_;
        for (std::size_t i = 0; i < by_.size(); ++i)
            for (auto& ring : result.areas[i].rings)
                for (Point& p : ring) p = {p.x + by_[i].x, p.y + by_[i].y};
        return result;
    }

private:
    const Drawing& drawing_;
    std::vector<Point> by_;
    std::vector<bool> small_;
    std::vector<Box> boxes_;
};

// The way to go for a point that is too close to a line, by the numbers of the point and of the line's chain: away from it if
// that is near enough, else onto it, where it joins it. What is on a line stays there.
std::map<std::pair<std::size_t, std::size_t>, Point> points_beside_lines(const Drawing& drawing, Seen& seen) {
    std::vector<bool> is_free;
    for (const Area& area : drawing.areas) is_free.push_back(area.role == Role::symbol && is_small(area));
    for (const Contact& contact : seen.geometry.contacts)
        for (const std::size_t c : {contact.one.chain, contact.other.chain})
            if (const Chain& chain = seen.geometry.chains[c]; chain.ring) is_free[chain.owner] = false;
    std::map<std::pair<std::size_t, std::size_t>, Point> ways;
    std::map<std::pair<std::size_t, std::size_t>, double> worst;
    for (std::size_t i = 0; i < seen.near.size(); ++i) {
        std::size_t point = seen.geometry.pieces[seen.near[i].one].chain, line = seen.geometry.pieces[seen.near[i].other].chain;
        const bool turned = !seen.geometry.chains[point].ring;
        if (turned) std::swap(point, line);
        const Chain &one = seen.geometry.chains[point], &other = seen.geometry.chains[line];
        if (!one.ring || other.ring || !is_free[one.owner] || !seen.near.is_too_close(i)) continue;
        NearPair pair = seen.near.pair(i);
        if (turned) std::swap(pair.at, pair.other_at);
        const double apart = distance(pair.at, pair.other_at), white = seen.near[i].white;
        const bool away = pair.lacks <= kFarthestMove, onto = white + kPushed <= kFarthestMove;
        if (apart == 0 || !(away || onto)) continue;
        const double by = (away ? pair.lacks + kPushed : -white - kPushed) / apart;
        if (const auto [known, fresh] = worst.try_emplace({one.owner, line}, pair.lacks); !fresh) {
            if (known->second >= pair.lacks) continue;
            known->second = pair.lacks;
        }
        ways[{one.owner, line}] = {(pair.at.x - pair.other_at.x) * by, (pair.at.y - pair.other_at.y) * by};
    }
    return ways;
}

void drop_empty(std::vector<Area>& areas) {
    std::erase_if(areas, [](const Area& area) { return area.rings.empty(); });
}

}  // namespace

Mends lighten(Drawing& drawing, const Medium& medium) {
    Mends changes;
    const auto limit = limit_of(*find_rule("ink-limit"), medium);
    if (!limit) return changes;
    std::vector<std::pair<double, std::size_t>> black;  // size and number, the largest last
    for (std::size_t i = 0; i < drawing.areas.size(); ++i)
        if (const Area& area = drawing.areas[i]; area.texture == 0 && !area.rings.empty() && !area.rings[0].empty())
            black.push_back({size_of(area), i});
    std::sort(black.begin(), black.end());
    while (!black.empty()) {
        const Page page = page_of(drawing, medium);
        const auto percent = percent_black(PageGeometry(page));
        if (!percent || *percent <= *limit) break;
        double spare = (*percent - *limit + kInkToSpare) / 100 * drawing.width * drawing.height;
        for (; spare > 0 && !black.empty(); black.pop_back()) {
            spare -= black.back().first;
            changes.push_back(to_outline(drawing, black.back().second));
        }
    }
    drop_empty(drawing.areas);
    return changes;
}

bool drop_rims(Drawing& drawing, Seen& seen) {
    std::vector<Box> boxes;
    for (const Area& area : drawing.areas)
        if (is_small(area)) boxes.push_back(box_of(area.rings[0]));
    const auto more_left = [](const Box& one, const Box& other) { return one.left < other.left; };
    std::sort(boxes.begin(), boxes.end(), more_left);
    const auto is_rim = [&](const Stroke& stroke) {
        const bool closed =
            stroke.closed || (stroke.points.size() > 2 && distance(stroke.points.front(), stroke.points.back()) < kRim);
        if (!closed) return false;
        const Box own = box_of(stroke.points), from{own.left - kRim, 0, 0, 0};
        for (auto box = std::lower_bound(boxes.begin(), boxes.end(), from, more_left);
             box != boxes.end() && box->left < own.left + kRim; ++box)
            if (std::max({std::abs(box->top - own.top), std::abs(box->right - own.right), std::abs(box->bottom - own.bottom)}) <
                kRim)
                return true;
        return false;
    };
    std::vector<bool> small, rims;  // areas, strokes
    for (const Area& area : drawing.areas) small.push_back(is_small(area));
    for (const Stroke& stroke : drawing.strokes) rims.push_back(is_rim(stroke));
    const auto is_crowded = [&](std::uint32_t piece) {
        const Chain& chain = seen.geometry.chains[seen.geometry.pieces[piece].chain];
        return chain.ring ? small[chain.owner] : rims[chain.owner];
    };
    for (std::size_t i = 0; i < seen.near.size(); ++i)
        if ((is_crowded(seen.near[i].one) || is_crowded(seen.near[i].other)) && seen.near.is_too_close(i))
            return std::erase_if(drawing.strokes, is_rim) > 0;
    return false;
}

Mends move_areas_apart(Drawing& drawing, const Medium& medium, Seen& seen) {
    Shifts shifts(drawing);
    auto close = close_areas(seen);
    auto beside = points_beside_lines(drawing, seen);
    const std::size_t first = close.size() + beside.size();
    Drawing shifted = drawing;
    for (int round = 0; round < kPushes && !(close.empty() && beside.empty()); ++round) {
        bool pushed = false;
        for (const auto& [areas, pair] : close) {
            const double apart = distance(pair.at, pair.other_at);
            const bool one = shifts.is_small_at(areas.first), other = shifts.is_small_at(areas.second);
            if (apart == 0 || pair.lacks > 2 * kFarthestMove || !(one || other)) continue;
            const double by = (pair.lacks + kPushed) / (one && other ? 2 : 1) / apart;
            const Point way{(pair.at.x - pair.other_at.x) * by, (pair.at.y - pair.other_at.y) * by};
            if (one) shifts.push(areas.first, way);
            if (other) shifts.push(areas.second, {-way.x, -way.y});
            pushed = true;
        }
        for (const auto& [point, way] : beside) shifts.push(point.first, way), pushed = true;
        if (!pushed) break;
        shifted = shifts.shifted();
        Seen anew(shifted, medium);
        close = close_areas(anew);
        beside = points_beside_lines(shifted, anew);
    }
    Mends changes;
    if (close.size() + beside.size() >= first) return changes;
    for (std::size_t i = 0; i < drawing.areas.size(); ++i)
        if (shifts.size_at(i) >= kNoticed)
            changes.push_back({Mend::Kind::shifted, first_point(drawing.areas[i]), shifts.size_at(i)});
    drawing = std::move(shifted);
    return changes;
}

namespace {

// Lines that end on points, or go through them, would lose them.
bool any_touches_line(const PageGeometry& geometry, const std::vector<double>& extents) {
    return std::any_of(geometry.contacts.begin(), geometry.contacts.end(), [&](const Contact& contact) {
        const Chain &one = geometry.chains[contact.one.chain], &other = geometry.chains[contact.other.chain];
        return one.ring != other.ring && extents[one.ring ? one.owner : other.owner] > 0;
    });
}

// The scale that leaves gaps between points of these extents, and between them and lines, where none becomes too small; 1:
// nothing helps.
double scale_for(Seen& seen, const std::vector<double>& extents) {
    double scale = 1;
    const auto extent_at = [&](std::uint32_t piece) {
        const Chain& chain = seen.geometry.chains[seen.geometry.pieces[piece].chain];
        return chain.ring ? extents[chain.owner] : 0;
    };
    for (std::size_t i = 0; i < seen.near.size(); ++i) {
        const double one = extent_at(seen.near[i].one), other = extent_at(seen.near[i].other);
        if ((one == 0 && other == 0) || !seen.near.is_too_close(i)) continue;
        const double needed = 1 - 2 * (seen.near.pair(i).lacks + kPushed) / (one + other);
        if (needed * std::max(one, other) >= kFoundPoint) scale = std::min(scale, needed);
    }
    return scale;
}

}  // namespace

Mends shrink_areas(Drawing& drawing, const Medium& medium, Seen& seen) {
    std::vector<double> extents = extents_of_points(drawing, kFoundPoint, kRecognised);
    const std::size_t first = close_areas(seen).size();
    if (extents.empty() || first == 0 || any_touches_line(seen.geometry, extents)) return {};
    const std::vector<double> before = extents;
    Drawing shrunk = drawing;
    std::size_t last = first;
    double scale = scale_for(seen, extents);
    // What touched becomes near when it is smaller, and may need more.
    for (int round = 0; round < kPushes && scale < 1; ++round) {
        for (std::size_t i = 0; i < extents.size(); ++i) {
            if (extents[i] == 0) continue;
            scale_about_middle(shrunk.areas[i], scale);
            extents[i] *= scale;
        }
        Seen anew(shrunk, medium);
        last = close_areas(anew).size();
        scale = scale_for(anew, extents);
    }
    Mends changes;
    if (last >= first) return changes;
    for (std::size_t i = 0; i < extents.size(); ++i)
        if (extents[i] < before[i])
            changes.push_back({Mend::Kind::shrunk, first_point(drawing.areas[i]), before[i] - extents[i]});
    drawing = std::move(shrunk);
    return changes;
}

Mends enlarge_specks(Drawing& drawing, const Medium& medium) {
    constexpr double kDot = kMarburgMedium.dot;
    if (has_fixed_dots(medium)) return {};
    const std::vector<double> extents = extents_of_points(drawing, 0, kDot);
    Drawing enlarged = drawing;
    Mends changes;
    for (std::size_t i = 0; i < extents.size(); ++i) {
        if (extents[i] == 0) continue;
        scale_about_middle(enlarged.areas[i], kDot / extents[i]);
        const Box box = box_of(enlarged.areas[i].rings[0]);
        if (box.left < 0 || box.top < 0 || box.right > drawing.width || box.bottom > drawing.height) return {};
        changes.push_back({Mend::Kind::enlarged, first_point(drawing.areas[i]), kDot - extents[i]});
    }
    if (changes.empty()) return {};
    Seen anew(enlarged, medium);
    for (std::size_t k = 0; k < anew.near.size(); ++k) {
        if (!anew.near.is_too_close(k)) continue;
        for (const std::uint32_t piece : {anew.near[k].one, anew.near[k].other}) {
            const Chain& chain = anew.geometry.chains[anew.geometry.pieces[piece].chain];
            if (chain.ring && extents[chain.owner] > 0) return {};
        }
    }
    drawing = std::move(enlarged);
    return changes;
}

Mends outline_areas(Drawing& drawing, Seen& seen) {
    Mends changes;
    if (drawing.areas.empty()) return changes;
    const PageGeometry& geometry = seen.geometry;
    const std::vector<std::size_t> worth = worth_of(geometry, drawing);
    std::set<std::size_t> too_close;  // areas
    for (std::size_t i = 0; i < seen.near.size(); ++i) {
        const std::uint32_t a = geometry.pieces[seen.near[i].one].chain, b = geometry.pieces[seen.near[i].other].chain;
        if (!geometry.chains[a].ring || !geometry.chains[b].ring || !seen.near.is_too_close(i)) continue;
        too_close.insert(geometry.chains[worth[a] < worth[b] ? a : b].owner);
    }
    for (const std::size_t i : too_close) {
        Area& area = drawing.areas[i];
        if (extent_of(area) >= kRecognised) {
            changes.push_back(to_outline(drawing, i));
            continue;
        }
        double length = 0;
        for (const auto& ring : area.rings) length += length_of(Stroke{ring, true});
        const auto kind = area.role == Role::symbol ? Mend::Kind::crowded : Mend::Kind::left_out;
        changes.push_back({kind, first_point(area), length});
        area.rings.clear();
    }
    drop_empty(drawing.areas);
    return changes;
}

}  // namespace tactics
