// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/plot_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tactics/haptics/voice/surface_place.h"
#include "tactics/text/named_unit.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

// "time" of "time (s)"; an axis without a name is called as it lies.
std::string name_of(const Axis& axis, const char* otherwise) {
    const std::string_view name = name_and_unit(axis.name).name;
    return name.empty() ? otherwise : std::string(name);
}

// A place that was worked out from an end of a curve may lie a rounding beyond it.
double met(const PlotCurve& curve, double x) {
    constexpr double kRounding = 1e-9;
    for (const PlotPoint& end : curve.points)
        if (std::abs(end.x - x) <= kRounding * std::max(std::abs(end.x), std::abs(x))) return end.x;
    return x;
}

double scaled(const Axis& axis, double value) { return axis.logarithmic ? std::log(value) : value; }

// mm along the axis, from its beginning.
double mm_along(const Axis& axis, const AxisSpan& span, double value) {
    const double from = scaled(axis, span.from), to = scaled(axis, span.to);
    return to == from ? 0 : (scaled(axis, value) - from) / (to - from) * span.mm;
}

bool begins_behind_gap(const PlotCurve& curve, std::size_t point) {
    return std::binary_search(curve.gaps.begin(), curve.gaps.end(), point);
}

std::string count_of(std::size_t number, std::size_t all) {
    return "point " + std::to_string(number + 1) + " of " + std::to_string(all);
}

}  // namespace

double height_of_curve(const Plot& plot, const PlotCurve& curve, double x) {
    const auto& points = curve.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const PlotPoint &a = points[i], &b = points[i + 1];
        if (a.x == x) return a.y;
        if (begins_behind_gap(curve, i + 1) || x < std::min(a.x, b.x) || x > std::max(a.x, b.x)) continue;
        if (b.x == x) return b.y;
        if (curve.joined != Joining::straight) return a.y;
        const double from = scaled(plot.x, a.x), share = (scaled(plot.x, x) - from) / (scaled(plot.x, b.x) - from);
        const double y = scaled(plot.y, a.y) + share * (scaled(plot.y, b.y) - scaled(plot.y, a.y));
        return plot.y.logarithmic ? std::exp(y) : y;
    }
    if (!points.empty() && points.back().x == x) return points.back().y;
    return std::numeric_limits<double>::quiet_NaN();
}

std::string PlotWords::value(const Axis& axis, const AxisSpan& span, double at) const {
    if (!std::isfinite(at)) return "not known";
    const double step = telling_step(span, axis.logarithmic, at);
    if (axis.dates) return spoken_date(at, step);
    // A logarithmic axis spans many powers of ten, so each value has its own.
    const double largest = axis.logarithmic ? 0 : std::max(std::abs(span.from), std::abs(span.to));
    const std::string_view unit = name_and_unit(axis.name).unit;
    return spoken_number(at, step, largest) + (unit.empty() ? "" : " ") + std::string(unit);
}

std::string PlotWords::value_of(const Axis& axis, const AxisSpan& span, const char* otherwise, double at) const {
    return name_of(axis, otherwise) + " " + value(axis, span, at);
}

const PlotCurve* PlotWords::curve(std::size_t series) const {
    return series < plot_->curves.size() ? &plot_->curves[series] : nullptr;
}

std::string PlotWords::name_of_curve(std::size_t series) const {
    const std::string& name = plot_->curves[series].name;
    return name.empty() ? "curve " + std::to_string(series + 1) : name;
}

std::string PlotWords::position(double x, double y, double z) const {
    std::string words = value_of(plot_->x, frame_.x, "x", x) + ", " + value_of(plot_->y, frame_.y, "y", y);
    if (!std::isnan(z)) words += ", " + value_of(plot_->z, frame_.z, "height", z);
    return words;
}

// In eight directions, of which each has an eighth of the circle.
std::string PlotWords::away(double right, double up) const {
    const double distance = std::hypot(right, up);
    if (!(distance >= 0.5)) return "under the finger";
    const double narrow = std::tan(std::acos(-1.0) / 8);
    std::string where;
    if (std::abs(up) > narrow * std::abs(right)) where = up > 0 ? "above" : "below";
    if (std::abs(right) > narrow * std::abs(up))
        where += std::string(where.empty() ? "" : ", ") + (right > 0 ? "to the right" : "to the left");
    return to_text(std::round(distance)) + " mm away " + where;
}

std::string PlotWords::nearest(double x, double y) const {
    const auto right_of = [&](double value) { return mm_along(plot_->x, frame_.x, value) - mm_along(plot_->x, frame_.x, x); };
    const auto above = [&](double value) { return mm_along(plot_->y, frame_.y, value) - mm_along(plot_->y, frame_.y, y); };
    double least = std::numeric_limits<double>::infinity();
    std::optional<std::size_t> at_curve, at_point, at_mark;
    const auto is_nearer = [&](double px, double py) {
        const double distance = std::hypot(right_of(px), above(py));
        if (!(distance < least)) return false;
        least = distance;
        return true;
    };
    for (std::size_t i = 0; i < plot_->curves.size(); ++i)
        for (std::size_t k = 0; k < plot_->curves[i].points.size(); ++k)
            if (is_nearer(plot_->curves[i].points[k].x, plot_->curves[i].points[k].y)) at_curve = i, at_point = k;
    for (std::size_t i = 0; i < plot_->marks.size(); ++i)
        if (is_nearer(plot_->marks[i].x, plot_->marks[i].y)) at_mark = i;
    if (at_mark) {
        const PlotMark& mark = plot_->marks[*at_mark];
        return "nearest: " + (mark.name.empty() ? count_of(*at_mark, plot_->marks.size()) : "point " + mark.name) + ", " +
               position(mark.x, mark.y, plot_->spatial ? mark.z : std::nan("")) + ", " + away(right_of(mark.x), above(mark.y));
    }
    if (!at_point) return "nearest: nothing";
    const PlotPoint& point = plot_->curves[*at_curve].points[*at_point];
    return "nearest: " + count_of(*at_point, plot_->curves[*at_curve].points.size()) +
           (plot_->curves.size() > 1 ? " of " + name_of_curve(*at_curve) : "") + ", " + position(point.x, point.y, std::nan("")) +
           ", " + away(right_of(point.x), above(point.y));
}

std::string PlotWords::under_finger(const Announcement& one) const {
    const auto x_is = [&] { return value(plot_->x, frame_.x, one.x); };
    const auto y_is = [&] { return value(plot_->y, frame_.y, one.y); };
    switch (one.felt) {
        case FeltPart::nothing: break;
        case FeltPart::curve: {
            if (curve(one.series) == nullptr) break;
            const bool named = !plot_->curves[one.series].name.empty();
            return (named ? "curve " : "") + name_of_curve(one.series);
        }
        case FeltPart::mark: {
            if (one.series >= plot_->marks.size()) break;
            const PlotMark& mark = plot_->marks[one.series];
            return (mark.name.empty() ? count_of(one.series, plot_->marks.size()) : "point " + mark.name) + ", " +
                   position(mark.x, mark.y, plot_->spatial ? mark.z : std::nan(""));
        }
        case FeltPart::surface:
            if (one.series >= plot_->surfaces.size()) break;
            return on_surface(one);
        case FeltPart::x_axis: return name_of(plot_->x, "x") + " axis";
        case FeltPart::y_axis: return name_of(plot_->y, "y") + " axis";
        case FeltPart::x_tick: return name_of(plot_->x, "x") + " axis, tick " + x_is();
        case FeltPart::y_tick: return name_of(plot_->y, "y") + " axis, tick " + y_is();
        case FeltPart::x_grid: return "grid line " + name_of(plot_->x, "x") + " " + x_is();
        case FeltPart::y_grid: return "grid line " + name_of(plot_->y, "y") + " " + y_is();
    }
    return "nothing";
}

// The slope under the finger, and the axes along which it rises: each with at least two fifths of the other's share, as for eight
// directions.
std::string PlotWords::on_surface(const Announcement& one) const {
    constexpr double kLevel = 0.05, kGentle = 0.27, kSteep = 1;  // 3, 15 and 45 degrees; ours
    const PlotSurface& surface = plot_->surfaces[one.series];
    const std::string number = plot_->surfaces.size() > 1 ? " " + std::to_string(one.series + 1) : "";
    const SurfacePlace at = place_on(surface, one.x, one.y);
    std::string words = "surface" + (surface.name.empty() ? number : " " + surface.name) + ", " +
                        value_of(plot_->z, frame_.z, "height", at.height);
    // mm upwards for a millimetre along each axis.
    const auto felt = [&](const Axis& axis, const AxisSpan& span, double value, double by) {
        return axis.logarithmic ? by * value * std::log(span.to / span.from) / span.mm : by * (span.to - span.from) / span.mm;
    };
    const double up = frame_.z.mm / (frame_.z.to - frame_.z.from);
    const double x = up * felt(plot_->x, frame_.x, one.x, at.along_x), y = up * felt(plot_->y, frame_.y, one.y, at.along_y);
    const double slope = std::hypot(x, y);
    if (!std::isfinite(at.height + slope)) return words;
    if (slope < kLevel) return words + ", level";
    words += slope < kGentle ? ", gentle slope" : slope < kSteep ? ", slope" : ", steep slope";
    const double narrow = std::tan(std::acos(-1.0) / 8);
    const auto goes = [&](const Axis& axis, const char* otherwise, double by, double other) {
        if (std::abs(by) > narrow * std::abs(other))
            words += (by > 0 ? ", rising with " : ", falling with ") + name_of(axis, otherwise);
    };
    goes(plot_->x, "x", x, y);
    goes(plot_->y, "y", y, x);
    return words;
}

std::string PlotWords::curve_end(const Announcement& one) const {
    const PlotCurve* of = curve(one.series);
    if (of == nullptr || of->points.empty()) return "nothing";
    const PlotPoint &first = of->points.front(), &last = of->points.back();
    const auto distance_to = [&](const PlotPoint& point) {
        return std::hypot(mm_along(plot_->x, frame_.x, point.x) - mm_along(plot_->x, frame_.x, one.x),
                          mm_along(plot_->y, frame_.y, point.y) - mm_along(plot_->y, frame_.y, one.y));
    };
    const bool begins = distance_to(first) < distance_to(last);
    const PlotPoint& end = begins ? first : last;
    const std::string name = of->name.empty() ? "" : " " + of->name;
    if (one.telling == Telling::curve_end)
        return (begins ? "beginning" : "end") + (" of the curve" + name) + ", " + position(end.x, end.y, std::nan(""));
    // A gap makes ends of pieces, after which the curve continues; a bar begins on the ground.
    constexpr double kAtEnd = 1;  // mm
    const bool piece = std::abs(mm_along(plot_->x, frame_.x, end.x) - mm_along(plot_->x, frame_.x, one.x)) > kAtEnd;
    return (begins ? "beginning" : "end") + ((piece ? " of a piece of the curve" : " of the curve") + name) + ", " +
           position(one.x, one.y, std::nan(""));
}

std::string PlotWords::extreme(const Announcement& one) const {
    const PlotCurve* of = curve(one.series);
    if (of == nullptr || of->points.empty()) return "nothing";
    const auto lower = [](const PlotPoint& a, const PlotPoint& b) { return a.y < b.y; };
    const bool highest = one.telling == Telling::highest;
    const auto at = highest ? std::max_element(of->points.begin(), of->points.end(), lower)
                            : std::min_element(of->points.begin(), of->points.end(), lower);
    return (highest ? "highest: " : "lowest: ") + position(at->x, at->y, std::nan(""));
}

std::string PlotWords::comparison(const Announcement& one) const {
    if (curve(one.series) == nullptr || curve(one.other) == nullptr) return "nothing";
    const double first = height_of_curve(*plot_, *curve(one.series), met(*curve(one.series), one.x));
    const double second = height_of_curve(*plot_, *curve(one.other), met(*curve(one.other), one.x));
    const std::string ours = name_of_curve(one.series), theirs = name_of_curve(one.other);
    const std::string one_is = value(plot_->y, frame_.y, first), other_is = value(plot_->y, frame_.y, second);
    const std::string words =
        "at " + value_of(plot_->x, frame_.x, "x", one.x) + ": " + ours + " " + one_is + ", " + theirs + " " + other_is;
    if (!std::isfinite(first) || !std::isfinite(second)) return words;
    if (one_is == other_is) return words + ", the same";
    const std::string higher = ", " + (first > second ? ours : theirs);
    if (plot_->y.dates) return words + higher + " later";
    // A difference is as fine as the axis, not as itself, which a logarithmic axis would take it for.
    const double step = telling_step(frame_.y, plot_->y.logarithmic, std::max(first, second));
    const double largest = plot_->y.logarithmic ? 0 : std::max(std::abs(frame_.y.from), std::abs(frame_.y.to));
    const std::string_view unit = name_and_unit(plot_->y.name).unit;
    return words + higher + " " + spoken_number(std::abs(first - second), step, largest) + (unit.empty() ? "" : " ") +
           std::string(unit) + " higher";
}

std::string PlotWords::of(const Announcement& one) const {
    switch (one.telling) {
        case Telling::hush: return "";
        case Telling::position: return position(one.x, one.y, one.z);
        case Telling::nearest: return nearest(one.x, one.y);
        case Telling::under_finger: return under_finger(one);
        case Telling::curve_end:
        case Telling::way_end: return curve_end(one);
        case Telling::highest:
        case Telling::lowest: return extreme(one);
        case Telling::comparison: return comparison(one);
        case Telling::maximum:
        case Telling::minimum:
            if (curve(one.series) == nullptr) return "nothing";
            return (one.telling == Telling::maximum ? "maximum" : "minimum") +
                   (plot_->curves.size() > 1 ? " of " + name_of_curve(one.series) : "") + ", " +
                   position(one.x, one.y, std::nan(""));
        case Telling::let_go: return "let go";
        case Telling::no_curve: return "there is no curve";
        case Telling::no_turn: return "no further maximum or minimum this way; once more goes back";
        case Telling::no_turns: return "this curve has no maximum or minimum";
        case Telling::no_other_curve: return "there is no other curve here";
        case Telling::choice: return std::string(key_of(one.action).name);
    }
    return "";
}

}  // namespace tactics
