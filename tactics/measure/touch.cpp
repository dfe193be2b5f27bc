// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/touch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace tactics {

namespace {

constexpr double kSamplesPerLeast = 8;
constexpr double kMeet = 0.25;  // of `least`: an end this near to a line is on it

// A short piece of stroke.
struct Piece {
    Point at;
    std::size_t stroke = 0;
    double along = 0;   // mm from the stroke's beginning
    double length = 0;  // mm that it stands for
};

// Pieces in squares of `least`, so that all within that distance are in nine squares.
class Squares {
public:
    Squares(const std::vector<Piece>& pieces, double side) : side_(side) {
        for (std::size_t i = 0; i < pieces.size(); ++i) squares_[key(pieces[i].at, 0, 0)].push_back(i);
    }

    template <typename Visit>
    void around(Point at, Visit visit) const {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const auto found = squares_.find(key(at, dx, dy));
                if (found == squares_.end()) continue;
                for (const std::size_t i : found->second) visit(i);
            }
    }

private:
    std::uint64_t key(Point at, int dx, int dy) const {
        const auto column = static_cast<std::int32_t>(std::floor(at.x / side_)) + dx;
        const auto row = static_cast<std::int32_t>(std::floor(at.y / side_)) + dy;
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(row)) << 32 | static_cast<std::uint32_t>(column);
    }

    double side_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> squares_;
};

std::vector<Piece> cut(const Drawing& drawing, const std::vector<double>& lengths, double step) {
    std::vector<Piece> pieces;
    for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
        const Stroke& stroke = drawing.strokes[s];
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(lengths[s] / step)));
        const double length = lengths[s] / static_cast<double>(count);
        const std::size_t sides = stroke.points.size() - (stroke.closed ? 0 : 1);
        double before = 0;  // mm up to the side at hand
        std::size_t done = 0;
        for (std::size_t i = 0; i < sides; ++i) {
            const Point a = stroke.points[i], b = stroke.points[(i + 1) % stroke.points.size()];
            const double side = distance(a, b);
            for (; done < count && (static_cast<double>(done) + 0.5) * length <= before + side; ++done) {
                const double along = (static_cast<double>(done) + 0.5) * length;
                const double t = side > 0 ? (along - before) / side : 0;
                pieces.push_back({{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, s, along, length});
            }
            before += side;
        }
    }
    return pieces;
}

class Crowding {
public:
    Crowding(const Drawing& drawing, const std::vector<double>& lengths, double least)
        : drawing_(drawing),
          lengths_(lengths),
          least_(least),
          pieces_(cut(drawing, lengths, least / kSamplesPerLeast)),
          squares_(pieces_, least),
          meetings_(drawing.strokes.size()) {
        for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
            if (drawing.strokes[s].closed) continue;
            find_meetings(s, drawing.strokes[s].points.front(), 0);
            find_meetings(s, drawing.strokes[s].points.back(), lengths[s]);
        }
    }

    double length() const {
        double sum = 0;
        for (const Piece& piece : pieces_) {
            bool crowded = false;
            squares_.around(piece.at, [&](std::size_t i) { crowded = crowded || crowds(piece, pieces_[i]); });
            if (crowded) sum += piece.length;
        }
        return sum;
    }

private:
    // An end of this stroke lies on another stroke, or another's on this.
    struct Meeting {
        double here = 0;  // mm along this stroke
        std::size_t other = 0;
        double there = 0;  // mm along the other
    };

    // Along one stroke, the shorter way round if it is closed.
    double way(std::size_t stroke, double a, double b) const {
        const double straight = std::abs(a - b);
        return drawing_.strokes[stroke].closed ? std::min(straight, lengths_[stroke] - straight) : straight;
    }

    void find_meetings(std::size_t stroke, Point end, double along) {
        // Pieces are points an eighth of `least` apart, so that none of a line that goes through `end` is farther.
        squares_.around(end, [&](std::size_t i) {
            const Piece& piece = pieces_[i];
            const bool same = piece.stroke == stroke && way(stroke, piece.along, along) < 2 * least_;
            if (same || distance(piece.at, end) > kMeet * least_) return;
            meetings_[stroke].push_back({along, piece.stroke, piece.along});
            meetings_[piece.stroke].push_back({piece.along, stroke, along});
        });
    }

    bool crowds(const Piece& a, const Piece& b) const {
        if (distance(a.at, b.at) >= least_) return false;
        if (a.stroke == b.stroke && way(a.stroke, a.along, b.along) < 2 * least_) return false;
        return std::none_of(meetings_[a.stroke].begin(), meetings_[a.stroke].end(), [&](const Meeting& meeting) {
            return meeting.other == b.stroke && way(a.stroke, a.along, meeting.here) < 2 * least_ &&
                   way(b.stroke, b.along, meeting.there) < 2 * least_;
        });
    }

    const Drawing& drawing_;
    const std::vector<double>& lengths_;
    double least_;
    std::vector<Piece> pieces_;
    Squares squares_;
    std::vector<std::vector<Meeting>> meetings_;
};

}  // namespace

TouchLoad touch_load(const Drawing& drawing, double least) {
    TouchLoad load;
    std::vector<double> lengths;
    for (const Stroke& stroke : drawing.strokes) {
        lengths.push_back(length_of(stroke));
        load.length += lengths.back();
    }
    load.strokes = drawing.strokes.size();
    load.crowded = Crowding(drawing, lengths, least).length();
    return load;
}

}  // namespace tactics
