// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/plot_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tactics {

namespace {

// Takes the points of a line one by one and keeps the fewest from which none is farther than a tolerance: from the last that was
// kept, a line may run in the directions that pass all points since within it (A. Sklansky and V. Gonzalez, "Fast polygonal
// approximation of digitized curves", Pattern Recognition 12, 1980). One pass, no memory but the line's own.
class Thinned {
public:
    explicit Thinned(double tolerance) : tolerance_(tolerance) {}

    void add(Point point) {
        if (points_.empty()) {
            points_.push_back(point);
            last_ = point;
            return;
        }
        const Point from = points_.back();
        const double away = distance(from, point);
        const bool back = away < farthest_ - tolerance_;  // the line has turned round
        if (back || !narrow(from, point, away)) {
            points_.push_back(last_);
            open_ = true;
            farthest_ = 0;
            narrow(last_, point, distance(last_, point));
        }
        last_ = point;
    }

    std::vector<Point> finish() {
        if (!points_.empty() && (points_.size() == 1 || distance(points_.back(), last_) > 0)) points_.push_back(last_);
        farthest_ = 0;
        open_ = true;
        return std::exchange(points_, {});
    }

private:
    // The directions that pass within the tolerance of this point, too. false: none does.
    bool narrow(Point from, Point point, double away) {
        farthest_ = std::max(farthest_, away);
        if (away <= tolerance_) return true;
        const double angle = std::atan2(point.y - from.y, point.x - from.x), half = std::asin(tolerance_ / away);
        if (open_) {
            middle_ = angle;
            low_ = -half;
            high_ = half;
            open_ = false;
            return true;
        }
        const double turn = std::remainder(angle - middle_, 2 * 3.14159265358979323846);
        if (turn < low_ || turn > high_) return false;
        low_ = std::max(low_, turn - half);
        high_ = std::min(high_, turn + half);
        return true;
    }

    double tolerance_;
    std::vector<Point> points_;
    Point last_;
    bool open_ = true;  // any direction may be taken
    double middle_ = 0, low_ = 0, high_ = 0, farthest_ = 0;
};

// Millions of points within a hair's breadth of each other: of each column as wide as the tolerance the first, the lowest, the
// highest and the last tell all that is drawn there (U. Jugel et al., "M4", VLDB 2014). Where a column is higher than wide, the
// stroke from its lowest to its highest passes the others within the tolerance, and the line comes in and goes out beside it.
class Columns {
public:
    Columns(double width, Thinned& into) : width_(width), into_(into) {}
    void add(Point point) {
        const double column = std::floor(point.x / width_);
        if (count_ > 0 && column != column_) flush(column == column_ + 1);
        if (count_ == 0) first_ = low_ = high_ = point, at_low_ = at_high_ = 0;
        column_ = column;
        if (point.y < low_.y) low_ = point, at_low_ = count_;
        if (point.y > high_.y) high_ = point, at_high_ = count_;
        last_ = point;
        ++count_;
    }
    void finish() {
        if (count_ > 0) flush(false);
    }

private:
    // `on`: the line goes on in the next column.
    void flush(bool on) {
        const bool stroke = high_.y - low_.y > width_;
        if (!stroke || !beside_ || at_low_ == 0 || at_high_ == 0) into_.add(first_);
        if (at_low_ > 0 && at_low_ < at_high_) into_.add(low_);
        if (at_high_ > 0) into_.add(high_);
        if (at_low_ > at_high_) into_.add(low_);
        if (count_ > 1 && (!stroke || !on)) into_.add(last_);
        beside_ = on;
        count_ = 0;
    }

    double width_, column_ = 0;
    Thinned& into_;
    Point first_, low_, high_, last_;
    std::size_t count_ = 0, at_low_ = 0, at_high_ = 0;
    bool beside_ = false;  // the line came from the column before
};

}  // namespace

double FeltAxis::share_of(double value) const noexcept {
    if (logarithmic) return std::log(value / low) / std::log(high / low);
    return (value - low) / (high - low);
}

double FeltAxis::value_at(double share) const noexcept {
    return logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
}

FeltLines felt_lines(const Plot& plot, const PlotFrame& frame, double resolution) {
    FeltLines felt;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const PlotCurve& curve = plot.curves[i];
        felt.points += curve.points.size();
        Thinned thinned(resolution / 2);
        Columns columns(resolution / 2, thinned);
        auto gap = curve.gaps.begin();
        const auto end_line = [&] {
            columns.finish();
            std::vector<Point> line = thinned.finish();
            if (line.size() < 2) return;
            felt.kept += line.size();
            felt.curve.push_back(i);
            felt.lines.push_back(std::move(line));
        };
        Point before;
        const double ground = frame.down(frame.y.logarithmic ? frame.y.low : 0);
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            const Point at{frame.across(curve.points[k].x), frame.down(curve.points[k].y)};
            const bool begins = k == 0 || (gap != curve.gaps.end() && *gap == k);
            if (gap != curve.gaps.end() && *gap == k) {
                end_line();
                ++gap;
            }
            if (curve.joined != Joining::straight && !begins) columns.add({at.x, before.y});
            if (curve.joined == Joining::bars) columns.add({at.x, ground});
            if (curve.joined != Joining::bars || k + 1 < curve.points.size()) columns.add(at);
            before = at;
        }
        end_line();
    }
    return felt;
}

}  // namespace tactics
