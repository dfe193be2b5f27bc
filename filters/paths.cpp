// SPDX-License-Identifier: Apache-2.0
#include "filters/paths.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "tactics/geometry/places.h"
#include "tactics/geometry/vectors.h"

namespace tactics {

namespace {

// Pieces that bend more than this at a junction are two lines. The arms of a symmetric Y bend by 60 degrees.
constexpr double kStraightOn = 0.643;  // cos 50 degrees
// Over a gap the eye goes on within about 30 degrees on either side (D. J. Field, A. Hayes, R. F. Hess, "Contour
// integration by the human visual system", Vision Research 33, 1993: up to 60 degrees between neighbouring elements).
constexpr double kAhead = 0.819;  // cos 35 degrees
// Length over which the direction of an end is measured, in pixels.
constexpr double kTangentLength = 8;

double length(Point a) { return std::sqrt(dot(a, a)); }
Point unit(Point a) {
    const double l = length(a);
    return l > 0 ? Point{a.x / l, a.y / l} : Point{};
}

// Direction in which `points` leaves its first point (backwards: in which it leaves its last one): from the mean of the
// first points to the mean of those after them.
Point direction_from(const std::vector<Point>& points, bool backwards, Point from, double skip) {
    const std::size_t size = points.size();
    Point near{}, far{};
    std::size_t count = 0;
    const auto at = [&](std::size_t i) { return points[backwards ? size - 1 - i : i]; };
    std::size_t begin = 0;
    while (begin < size && length(at(begin) - from) < skip) ++begin;
    if (begin + 2 > size) begin = 0;
    std::size_t end = begin;
    while (end < size && length(at(end) - at(begin)) < kTangentLength) ++end;
    const std::size_t half = (end - begin) / 2;
    for (std::size_t i = 0; i < half; ++i) {
        const Point a = at(begin + i), b = at(end - 1 - i);
        near = {near.x + a.x, near.y + a.y};
        far = {far.x + b.x, far.y + b.y};
        ++count;
    }
    if (count == 0) return size == 0 ? Point{} : unit(at(size - 1) - from);
    return unit(far - near);
}

// Ends of chains and paths are numbered 2 * index + (0 first, 1 last).
constexpr std::size_t kNoEnd = static_cast<std::size_t>(-1);

struct Meeting {
    double cost;
    std::size_t a, b;
    bool operator<(const Meeting& other) const { return std::tie(cost, a, b) < std::tie(other.cost, other.a, other.b); }
};

std::vector<std::size_t> partners_of(const PixelGraph& graph) {
    const auto& chains = graph.chains;
    std::vector<std::size_t> partner(2 * chains.size(), kNoEnd);
    std::vector<std::pair<int, std::size_t>> ends;  // junction, end
    for (std::size_t i = 0; i < chains.size(); ++i) {
        if (chains[i].from >= 0) ends.emplace_back(chains[i].from, 2 * i);
        if (chains[i].to >= 0) ends.emplace_back(chains[i].to, 2 * i + 1);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<Point> tangents;
    std::vector<Meeting> meetings;
    for (std::size_t begin = 0, stop; begin < ends.size(); begin = stop) {
        const PixelJunction& junction = graph.junctions[static_cast<std::size_t>(ends[begin].first)];
        tangents.clear();
        meetings.clear();
        for (stop = begin; stop < ends.size() && ends[stop].first == ends[begin].first; ++stop) {
            const PixelChain& chain = chains[ends[stop].second / 2];
            if (chain.points.empty()) {
                const int other = (ends[stop].second & 1u) != 0 ? chain.from : chain.to;
                tangents.push_back(unit(graph.junctions[static_cast<std::size_t>(other)].at - junction.at));
            } else {
                tangents.push_back(direction_from(chain.points, (ends[stop].second & 1u) != 0, junction.at, junction.reach));
            }
        }
        for (std::size_t a = 0; a < tangents.size(); ++a)
            for (std::size_t b = a + 1; b < tangents.size(); ++b)
                if (const double bend = -dot(tangents[a], tangents[b]);
                    bend > kStraightOn && chains[ends[begin + a].second / 2].kind == chains[ends[begin + b].second / 2].kind)
                    meetings.push_back({-bend, begin + a, begin + b});
        std::sort(meetings.begin(), meetings.end());
        for (const Meeting& meeting : meetings) {
            const std::size_t a = ends[meeting.a].second, b = ends[meeting.b].second;
            if (partner[a] != kNoEnd || partner[b] != kNoEnd) continue;
            partner[a] = b;
            partner[b] = a;
        }
    }
    return partner;
}

// The points of a chain without those that its junctions have bent; those are left only where the chain ends.
void append(std::vector<Point>& to, const PixelGraph& graph, const std::vector<std::size_t>& partner, std::size_t end) {
    const PixelChain& chain = graph.chains[end / 2];
    const bool backwards = (end & 1u) != 0;
    const std::size_t size = chain.points.size();
    std::size_t first = 0, last = size;
    if (chain.from >= 0 && partner[end & ~std::size_t{1}] != kNoEnd) {
        const PixelJunction& j = graph.junctions[static_cast<std::size_t>(chain.from)];
        while (first < size && length(chain.points[first] - j.at) < j.reach) ++first;
    }
    if (chain.to >= 0 && partner[end | 1u] != kNoEnd) {
        const PixelJunction& j = graph.junctions[static_cast<std::size_t>(chain.to)];
        while (last > 0 && length(chain.points[last - 1] - j.at) < j.reach) --last;
    }
    if (first >= last) {
        first = size / 2;
        last = std::min(size, first + 1);
    }
    to.reserve(to.size() + (last - first) + 1);
    for (std::size_t i = first; i < last; ++i) to.push_back(chain.points[backwards ? last - 1 - (i - first) : i]);
}

int junction_at(const PixelChain& chain, std::size_t end) { return (end & 1u) != 0 ? chain.to : chain.from; }

}  // namespace

std::vector<PixelPath> join_at_junctions(const PixelGraph& graph) {
    const auto partner = partners_of(graph);
    std::vector<PixelPath> paths;
    std::vector<bool> used(graph.chains.size(), false);
    const auto assemble = [&](std::size_t start) {
        PixelPath path;
        const auto place = [&](std::size_t end, int side) {
            const int junction = junction_at(graph.chains[end / 2], end);
            if (junction < 0) return;
            path.free[side] = false;
            path.ends_at[side] = junction;
            path.points.push_back(graph.junctions[static_cast<std::size_t>(junction)].at);
        };
        path.closed = graph.chains[start / 2].closed;
        path.kind = graph.chains[start / 2].kind;
        const bool loop = partner[start] != kNoEnd;  // only when every line with an end has been taken
        if (!loop && !path.closed) place(start, 0);
        for (std::size_t end = start;;) {
            used[end / 2] = true;
            append(path.points, graph, partner, end);
            const std::size_t arrival = end ^ 1u;
            if (partner[arrival] == kNoEnd) {
                if (!path.closed) place(arrival, 1);
                break;
            }
            path.passes.push_back(junction_at(graph.chains[arrival / 2], arrival));
            end = partner[arrival];
            if (end == start) {
                path.closed = true;
                break;
            }
        }
        if (path.points.size() >= (path.closed ? 3u : 2u)) paths.push_back(std::move(path));
    };
    for (std::size_t i = 0; i < graph.chains.size(); ++i)
        for (std::size_t end = 2 * i; end < 2 * i + 2; ++end)
            if (!used[i] && partner[end] == kNoEnd) assemble(end);
    for (std::size_t i = 0; i < graph.chains.size(); ++i)
        if (!used[i]) assemble(2 * i);
    return paths;
}

namespace {

struct End {
    std::size_t id;
    Point at;
    Point ahead;    // direction in which the line would go on
    double length;  // of the piece, in pixels
};

double length_of(const std::vector<Point>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += length(points[i] - points[i - 1]);
    return sum;
}

// What joining two ends costs, or a negative number if they do not belong together.
double cost_of(const End& a, const End& b, double gap) {
    const Point across = b.at - a.at;
    const double apart = length(across);
    if (apart > gap || a.length < apart || b.length < apart) return -1;
    if (a.id / 2 == b.id / 2 && a.length < 4 * apart + kTangentLength) return -1;
    const double turn = -dot(a.ahead, b.ahead);
    // Over a step or two the way across tells nothing: the grid decides it.
    if (apart <= 2.5) return turn > kStraightOn && dot(a.ahead, across) >= 0 ? apart * (2 - turn) : -1;
    const double from_a = dot(a.ahead, across) / apart, to_b = -dot(b.ahead, across) / apart;
    if (from_a < kAhead || to_b < kAhead) return -1;
    return apart * (3 - from_a - to_b);
}

std::vector<Meeting> meetings_of(const std::vector<End>& ends, double gap) {
    // No gap is longer than the shorter of its two pieces, so each end looks only that far and only for pieces that are no
    // shorter: however dense a picture of scraps is, the work stays in proportion.
    constexpr double kCell = 16, kRounding = 1e-6;
    Box all = kNothing;
    for (const End& end : ends) all.take(end.at);
    Places places(all, kCell);
    for (const End& end : ends) places.add(end.at);
    std::vector<Meeting> meetings;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const End& end = ends[i];
        places.any_near(end.at, std::min(gap, end.length) + kRounding, [&](std::size_t number) {
            const End& other = ends[number];
            if (other.length < end.length || (other.length == end.length && number <= i)) return false;
            if (const double cost = cost_of(end, other, gap); cost >= 0) meetings.push_back({cost, end.id, other.id});
            return false;
        });
    }
    std::sort(meetings.begin(), meetings.end());
    return meetings;
}

std::vector<End> free_ends_of(const std::vector<PixelPath>& paths) {
    std::vector<End> ends;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (paths[i].closed) continue;
        const double total = length_of(paths[i].points);
        for (std::size_t side = 0; side < 2; ++side) {
            if (!paths[i].free[side]) continue;
            const Point at = side == 0 ? paths[i].points.front() : paths[i].points.back();
            const Point inwards = direction_from(paths[i].points, side == 1, at, 0);
            ends.push_back({2 * i + side, at, {-inwards.x, -inwards.y}, total});
        }
    }
    return ends;
}

}  // namespace

void bridge(std::vector<PixelPath>& paths, double gap) {
    if (gap <= 0) return;
    const auto ends = free_ends_of(paths);
    std::vector<std::size_t> partner(2 * paths.size(), kNoEnd);
    for (const Meeting& meeting : meetings_of(ends, gap)) {
        if (partner[meeting.a] != kNoEnd || partner[meeting.b] != kNoEnd) continue;
        partner[meeting.a] = meeting.b;
        partner[meeting.b] = meeting.a;
    }
    std::vector<PixelPath> joined;
    std::vector<bool> used(paths.size(), false);
    const auto assemble = [&](std::size_t start) {
        PixelPath path;
        path.closed = paths[start / 2].closed;
        path.kind = paths[start / 2].kind;
        path.free[0] = paths[start / 2].free[start & 1u];
        path.ends_at[0] = paths[start / 2].ends_at[start & 1u];
        for (std::size_t end = start;;) {
            PixelPath& piece = paths[end / 2];
            used[end / 2] = true;
            path.free[1] = piece.free[1 - (end & 1u)];
            path.ends_at[1] = piece.ends_at[1 - (end & 1u)];
            if ((end & 1u) != 0) {
                std::reverse(piece.points.begin(), piece.points.end());
                std::reverse(piece.passes.begin(), piece.passes.end());
            }
            path.passes.insert(path.passes.end(), piece.passes.begin(), piece.passes.end());
            if (path.points.empty())
                path.points = std::move(piece.points);
            else
                path.points.insert(path.points.end(), piece.points.begin(), piece.points.end());
            end = partner[end ^ 1u];
            if (end == start) path.closed = true;
            if (end == kNoEnd || end == start) break;
        }
        joined.push_back(std::move(path));
    };
    for (std::size_t end = 0; end < partner.size(); ++end)
        if (!used[end / 2] && partner[end] == kNoEnd) assemble(end);
    for (std::size_t i = 0; i < paths.size(); ++i)
        if (!used[i]) assemble(2 * i);
    paths = std::move(joined);
}

void attach_ends(std::vector<PixelPath>& paths, const PixelGraph& graph) {
    struct Foot {
        bool wanted = false;
        double distance = 0;  // from the junction
        Point at;
    };
    std::vector<Foot> feet(graph.junctions.size());
    for (std::size_t i = 0; i < feet.size(); ++i) feet[i] = {false, 2 * graph.junctions[i].reach + 2, graph.junctions[i].at};
    for (const PixelPath& path : paths)
        for (const int junction : path.ends_at)
            if (junction >= 0) feet[static_cast<std::size_t>(junction)].wanted = true;
    for (const PixelPath& path : paths) {
        // Junctions come in the order in which the line passes them, so each is looked for from the one before.
        std::size_t from = 1;
        for (const int junction : path.passes) {
            Foot& foot = feet[static_cast<std::size_t>(junction)];
            if (!foot.wanted) continue;
            const PixelJunction& place = graph.junctions[static_cast<std::size_t>(junction)];
            const double near = 2 * place.reach + 4;
            std::size_t i = from;
            while (i < path.points.size() && length(path.points[i] - place.at) > near) ++i;
            for (; i < path.points.size() && length(path.points[i] - place.at) <= near; ++i) {
                const Point a = path.points[i - 1], along = path.points[i] - a;
                const double square = dot(along, along);
                const double t = square > 0 ? std::clamp(dot(place.at - a, along) / square, 0.0, 1.0) : 0;
                const Point at{a.x + t * along.x, a.y + t * along.y};
                const double distance = length(at - place.at);
                if (distance >= foot.distance) continue;
                foot.distance = distance;
                foot.at = at;
                from = i;
            }
        }
    }
    for (PixelPath& path : paths) {
        if (path.closed) continue;
        if (path.ends_at[0] >= 0) path.points.front() = feet[static_cast<std::size_t>(path.ends_at[0])].at;
        if (path.ends_at[1] >= 0) path.points.back() = feet[static_cast<std::size_t>(path.ends_at[1])].at;
    }
}

void reach_lines(std::vector<PixelPath>& paths, double gap, int width, int height) {
    if (gap <= 0) return;
    InkMap drawn(width, height);
    for (const PixelPath& path : paths)
        for (const Point& p : path.points) drawn.row(static_cast<int>(p.y))[static_cast<int>(p.x)] = 1;
    // Rays ahead, 0, 12 and 24 degrees to either side, the middle one first: a line that crosses the way meets one of them.
    constexpr Point kTurns[] = {{1, 0}, {0.978, 0.208}, {0.978, -0.208}, {0.914, 0.407}, {0.914, -0.407}};
    for (const End& end : free_ends_of(paths)) {
        const double most = std::min(gap, end.length);
        Point found{};
        double nearest = most;
        for (const Point turn : kTurns) {
            const Point way{end.ahead.x * turn.x - end.ahead.y * turn.y, end.ahead.y * turn.x + end.ahead.x * turn.y};
            for (double r = 1.5; r < nearest; r += 0.5) {  // nearer than that are the end's own pixels
                const int x = static_cast<int>(std::floor(end.at.x + r * way.x)),
                          y = static_cast<int>(std::floor(end.at.y + r * way.y));
                if (x < 0 || y < 0 || x >= width || y >= height) break;
                if (!drawn.ink(x, y)) continue;
                nearest = r;
                found = {x + 0.5, y + 0.5};
            }
        }
        if (nearest >= most) continue;
        PixelPath& path = paths[end.id / 2];
        path.points.insert((end.id & 1u) == 0 ? path.points.begin() : path.points.end(), found);
        path.free[end.id & 1u] = false;
    }
}

}  // namespace tactics
