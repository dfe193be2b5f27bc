// SPDX-License-Identifier: Apache-2.0
#include "filters/curves_apart.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/geometry/course.h"
#include "tactics/geometry/places.h"
#include "tactics/geometry/shape.h"

namespace tactics {

namespace {

using Line = std::vector<Point>;

constexpr double kCurveStep = 0.25;    // mm from one place that is looked at to the next
constexpr double kMostSteps = 400000;  // of all curves; of longer ones places are farther apart
constexpr double kTolerance = 0.05;    // mm
constexpr double kCurveBend = 4;       // tactics/rules/narrow.h

bool is_closed(const Line& line) { return line.size() > 3 && distance(line.front(), line.back()) == 0; }

struct Place {
    Point at;
    double along = 0;
};

// With places in between, so that none is farther than a step from the next.
std::vector<Place> dense(const Line& line, double step) {
    std::vector<Place> places;
    double along = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point a = line[i], b = line[i + 1];
        const double side = distance(a, b);
        const int steps = std::max(1, static_cast<int>(std::ceil(side / step)));
        for (int k = 0; k < steps; ++k)
            places.push_back({{a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps}, along + side * k / steps});
        along += side;
    }
    if (!line.empty()) places.push_back({line.back(), along});
    return places;
}

// What a place that is drawn belongs to.
struct Origin {
    std::size_t curve = 0, piece = 0;  // of all that are drawn
    double along = 0;
};

class Parting {
public:
    Parting(const std::vector<ApartCurve>& curves, const ApartWish& wish) : wish_(wish), places_(kNothing, 1) {
        Box box = kNothing;
        double length = 0;
        for (const ApartCurve& curve : curves) {
            widest_ = std::max(widest_, curve.width);
            for (const Line& line : curve.lines) {
                for (const Point& p : line) box.take(p);
                if (!line.empty()) length += length_of(line, false);
            }
        }
        step_ = std::max(kCurveStep, length / kMostSteps);
        places_ = Places(box, apart(widest_, widest_));
    }

    std::vector<Line> pieces_of(const ApartCurve& curve, std::size_t number) {
        curve_ = &curve;
        number_ = number;
        std::vector<Line> pieces;
        for (const Line& line : curve.lines) add_pieces(course_of(line, kTolerance), pieces);
        if (!curve.apart_itself)
            for (const Line& piece : pieces)
                for (const Place& place : dense(piece, step_)) draw(place);
        return pieces;
    }

private:
    double apart(double width, double other) const {
        return std::max(wish_.gap + (width + other) / 2, wish_.rows) + 2 * kTolerance;
    }

    void draw(const Place& place) {
        places_.add(place.at);
        origins_.push_back({number_, piece_, place.along});
        widths_.push_back(curve_->width);
    }

    void take_back(std::size_t size) {
        places_.shrink(size);
        origins_.resize(size);
        widths_.resize(size);
    }

    // `round` is the length of a closed line, whose last piece goes on into the first.
    bool is_free(const Place& place, double round) const {
        if (wish_.blocked && wish_.blocked(number_, place.at)) return false;
        return !places_.any_near(place.at, apart(curve_->width, widest_), [&](std::size_t i) {
            const Origin& other = origins_[i];
            const double away = distance(places_[i], place.at), least = apart(curve_->width, widths_[i]);
            if (away >= least) return false;
            if (other.curve != number_) return true;
            if (!curve_->apart_itself) return false;
            double way = std::abs(other.along - place.along);
            if (other.piece != piece_) {
                if (!(round > 0) || other.piece != first_piece_) return true;
                way = round - way;  // the other way round there is a break
            } else if (round > 0 && piece_ == first_piece_) {
                way = std::min(way, round - way);
            }
            return way > kCurveBend * away && way > kCurveBend * curve_->width;
        });
    }

    void add_pieces(const Line& line, std::vector<Line>& pieces) {
        const std::vector<Place> places = dense(line, step_);
        const bool closed = is_closed(line);
        const double round = closed ? places.back().along : 0;
        const std::size_t first_piece = pieces.size();
        first_piece_ = ++piece_;
        Line piece;
        bool whole = true, first_kept = false;
        double begun = 0;
        std::size_t drawn = places_.size();
        const auto end = [&](bool last) {
            // A closed line that is cut begins in the middle of a piece: its ends are one, however short they are.
            const bool joined = closed && !whole && (last || (begun == 0 && first_kept));
            if (piece.empty()) return;
            // What is within a small ring is felt as filled.
            const double least = closed && whole ? std::numbers::pi * apart(curve_->width, curve_->width) : wish_.least;
            if (piece.size() > 1 && (joined || length_of(piece, false) >= least))
                pieces.push_back(piece);
            else
                take_back(drawn);
            piece.clear();
            ++piece_;
        };
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool free = is_free(places[i], round);
            if (!free) {
                whole = false;
                end(false);
                continue;
            }
            if (i == 0) first_kept = true;
            if (piece.empty()) {
                begun = places[i].along;
                drawn = places_.size();
            }
            piece.push_back(places[i].at);
            if (curve_->apart_itself) draw(places[i]);
        }
        const bool last_kept = !piece.empty();
        end(true);
        if (closed && !whole && first_kept && last_kept && pieces.size() > first_piece + 1) join_ends(pieces, first_piece);
        std::erase_if(pieces, [&](const Line& each) { return length_of(each, false) < wish_.least; });
        for (std::size_t i = first_piece; i < pieces.size(); ++i) pieces[i] = course_of(pieces[i], kTolerance);
    }

    static void join_ends(std::vector<Line>& pieces, std::size_t first) {
        Line joined = std::move(pieces.back());
        pieces.pop_back();
        joined.insert(joined.end(), pieces[first].begin() + 1, pieces[first].end());
        pieces[first] = std::move(joined);
    }

    const ApartWish& wish_;
    double widest_ = 0, step_ = kCurveStep;
    Places places_;
    std::vector<Origin> origins_;
    std::vector<double> widths_;
    const ApartCurve* curve_ = nullptr;
    std::size_t number_ = 0, piece_ = 0, first_piece_ = 0;  // that are drawn now
};

}  // namespace

std::vector<std::vector<std::vector<Point>>> curves_apart(const std::vector<ApartCurve>& curves, const ApartWish& wish) {
    std::vector<std::vector<Line>> all;
    Parting parting(curves, wish);
    for (std::size_t i = 0; i < curves.size(); ++i) all.push_back(parting.pieces_of(curves[i], i));
    return all;
}

}  // namespace tactics
