// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/touch.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tactics/geometry/places.h"
#include "tactics/geometry/walk.h"

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

std::vector<Piece> cut(const Drawing& drawing, const std::vector<double>& lengths, double step) {
    std::vector<Piece> pieces;
    for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
        const Stroke& stroke = drawing.strokes[s];
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(lengths[s] / step)));
        const double length = lengths[s] / static_cast<double>(count);
        Walk walk(stroke.points, stroke.closed);
        for (std::size_t i = 0; i < count; ++i) {
            const double along = (static_cast<double>(i) + 0.5) * length;
            pieces.push_back({walk.to(along), s, along, length});
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
          places_({0, 0, drawing.width, drawing.height}, least),
          meetings_(drawing.strokes.size()) {
        for (const Piece& piece : pieces_) places_.add(piece.at);
        for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
            if (drawing.strokes[s].closed) continue;
            find_meetings(s, drawing.strokes[s].points.front(), 0);
            find_meetings(s, drawing.strokes[s].points.back(), lengths[s]);
        }
    }

    double length() const {
        double sum = 0;
        for (const Piece& piece : pieces_) {
            if (places_.any_near(piece.at, least_, [&](std::size_t i) { return crowds(piece, pieces_[i]); })) sum += piece.length;
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
        places_.any_near(end, least_, [&](std::size_t i) {
            const Piece& piece = pieces_[i];
            const bool same = piece.stroke == stroke && way(stroke, piece.along, along) < 2 * least_;
            if (same || distance(piece.at, end) > kMeet * least_) return false;
            meetings_[stroke].push_back({along, piece.stroke, piece.along});
            meetings_[piece.stroke].push_back({piece.along, stroke, along});
            return false;
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
    Places places_;
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
