// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/thin_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tactics/geometry/course.h"
#include "tactics/geometry/distance.h"

namespace tactics {

namespace {

constexpr double kPiece = 0.25;  // of the least distance: how finely a line is looked at

struct LinePiece {
    Segment ends;
    bool kept = true;
};

double off_sides(const std::vector<Segment>& sides, Point at) {
    double least = std::numeric_limits<double>::infinity();
    for (const Segment& side : sides) least = std::min(least, distance_to_segment(at, side.a, side.b));
    return least;
}

Point foot_on(const std::vector<Segment>& sides, Point at) {
    Point best = at;
    double least = std::numeric_limits<double>::infinity();
    for (const Segment& side : sides) {
        const Point on = nearest_on(side, at);
        if (distance(on, at) >= least) continue;
        least = distance(on, at);
        best = on;
    }
    return best;
}

std::vector<Segment> sides_of_ring(const std::vector<Point>& ring, bool closed = true) {
    std::vector<Segment> sides;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < ring.size(); ++i) sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
    return sides;
}

std::vector<LinePiece> pieces_of(const LaidLine& line, double longest) {
    constexpr int kMostPieces = 64;  // of a side
    std::vector<LinePiece> pieces;
    for (const Segment& side : sides_of_ring(line.points, line.closed)) {
        const int count = std::clamp(static_cast<int>(std::ceil(distance(side.a, side.b) / longest)), 1, kMostPieces);
        const auto at = [&](int i) {
            const double share = static_cast<double>(i) / count;
            return Point{side.a.x + share * (side.b.x - side.a.x), side.a.y + share * (side.b.y - side.a.y)};
        };
        for (int i = 0; i < count; ++i) pieces.push_back({{at(i), at(i + 1)}});
    }
    return pieces;
}

// What is left of a line, each stretch by itself.
std::vector<LaidLine> what_is_left(const std::vector<LinePiece>& pieces, bool closed, const std::vector<Segment>& outer) {
    const std::size_t count = pieces.size();
    std::size_t begin = 0;  // of a closed line, where a stretch begins
    while (closed && begin < count && !(pieces[begin].kept && !pieces[(begin + count - 1) % count].kept)) ++begin;
    std::vector<LaidLine> left;
    bool going = false;
    const auto join = [&](std::vector<Point>& points, Point at, bool first) {
        const Point on = foot_on(outer, at);
        if (distance(on, at) > 0) points.insert(first ? points.begin() : points.end(), on);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const LinePiece& piece = pieces[(begin + i) % count];
        const bool is_end = !closed && i == 0;
        if (piece.kept && !going) {
            left.push_back({{piece.ends.a}, false});
            if (!is_end) join(left.back().points, piece.ends.a, true);
        }
        if (piece.kept) left.back().points.push_back(piece.ends.b);
        if (!piece.kept && going) join(left.back().points, left.back().points.back(), false);
        going = piece.kept;
    }
    if (going && closed) join(left.back().points, left.back().points.back(), false);
    return left;
}

// Of those that are not kept, what is so short that it only comes away from an outer side stays. How many others there are.
std::size_t drop_stretches(std::vector<LinePiece>& pieces, double apart) {
    constexpr double kComesAway = 1.5;  // of the least distance
    std::size_t stretches = 0;
    for (std::size_t begin = 0, end = 0; begin < pieces.size(); begin = end) {
        double length = 0;
        for (end = begin; end < pieces.size() && pieces[end].kept == pieces[begin].kept; ++end)
            length += distance(pieces[end].ends.a, pieces[end].ends.b);
        if (pieces[begin].kept) continue;
        if (length > kComesAway * apart)
            ++stretches;
        else
            for (std::size_t i = begin; i < end; ++i) pieces[i].kept = true;
    }
    return stretches;
}

}  // namespace

std::size_t leave_out_inner(std::vector<LaidLine>& lines, const std::vector<std::vector<Point>>& outline, double touching,
                            double apart) {
    if (!(apart > 2 * touching)) return 0;
    std::vector<Segment> border, outer;
    for (const auto& ring : outline)
        for (const Segment& side : sides_of_ring(ring)) border.push_back(side);
    std::vector<std::vector<LinePiece>> pieces;
    for (const LaidLine& line : lines) {
        pieces.push_back(pieces_of(line, kPiece * apart));
        for (const Segment& side : sides_of_ring(line.points, line.closed))
            if (std::max({off_sides(border, side.a), off_sides(border, side.b), off_sides(border, middle_of(side))}) <= touching)
                outer.push_back(side);
    }
    if (outer.empty()) return 0;
    std::size_t left_out = 0;
    std::vector<LaidLine> kept;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (LinePiece& piece : pieces[i]) {
            const double off = off_sides(outer, middle_of(piece.ends));
            piece.kept = off <= touching || off >= apart;
        }
        const std::size_t stretches = drop_stretches(pieces[i], apart);
        left_out += stretches;
        if (stretches == 0)
            kept.push_back(std::move(lines[i]));
        else
            for (LaidLine& one : what_is_left(pieces[i], lines[i].closed, outer)) kept.push_back(std::move(one));
    }
    lines = std::move(kept);
    return left_out;
}

}  // namespace tactics
