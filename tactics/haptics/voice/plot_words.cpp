// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/plot_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "tactics/haptics/voice/surface_place.h"
#include "tactics/text/named_unit.h"

namespace tactics {

namespace {

// "time" of "time (s)"; an axis without a name is called as it lies.
Phrase name_of(const Axis& axis, const Phrase& otherwise) {
    const std::string_view name = name_and_unit(axis.name).name;
    return name.empty() ? otherwise : Phrase(name);
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

Phrase with_unit(Phrase number, const Axis& axis) {
    const std::string_view unit = name_and_unit(axis.name).unit;
    return unit.empty() ? number : phrase("{0} {1}", std::move(number), unit);
}

Phrase name_of_mark(const Plot& plot, std::size_t number) {
    const std::string& name = plot.marks[number].name;
    if (!name.empty()) return phrase("point {0}", name);
    return phrase("point {0} of {1}", std::to_string(number + 1), std::to_string(plot.marks.size()));
}

// In eight directions, of which each has an eighth of the circle.
Phrase away(double right, double up) {
    const double distance = std::hypot(right, up);
    if (!(distance >= 0.5)) return phrase("under the finger");
    const double narrow = std::tan(std::acos(-1.0) / 8);
    const Phrase mm = numeral(std::round(distance));
    if (std::abs(right) <= narrow * std::abs(up))
        return up > 0 ? phrase("{0} mm away above", mm) : phrase("{0} mm away below", mm);
    if (std::abs(up) <= narrow * std::abs(right))
        return right > 0 ? phrase("{0} mm away to the right", mm) : phrase("{0} mm away to the left", mm);
    if (up > 0) return right > 0 ? phrase("{0} mm away above, to the right", mm) : phrase("{0} mm away above, to the left", mm);
    return right > 0 ? phrase("{0} mm away below, to the right", mm) : phrase("{0} mm away below, to the left", mm);
}

// An end of a curve, or of a piece of it, which may have a name.
Phrase name_of_end(bool begins, bool piece, const std::string& curve) {
    if (curve.empty()) {
        if (piece) return begins ? phrase("beginning of a piece of the curve") : phrase("end of a piece of the curve");
        return begins ? phrase("beginning of the curve") : phrase("end of the curve");
    }
    if (piece)
        return begins ? phrase("beginning of a piece of the curve {0}", curve) : phrase("end of a piece of the curve {0}", curve);
    return begins ? phrase("beginning of the curve {0}", curve) : phrase("end of the curve {0}", curve);
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

Phrase PlotWords::value(const Axis& axis, const AxisSpan& span, double at) const {
    if (!std::isfinite(at)) return phrase("not known");
    const double step = telling_step(span, axis.logarithmic, at);
    if (axis.dates) return spoken_date(at, step);
    // A logarithmic axis spans many powers of ten, so each value has its own.
    const double largest = axis.logarithmic ? 0 : std::max(std::abs(span.from), std::abs(span.to));
    return with_unit(spoken_number(at, step, largest), axis);
}

Phrase PlotWords::value_of(const Axis& axis, const AxisSpan& span, const Phrase& otherwise, double at) const {
    return phrase("{0} {1}", name_of(axis, otherwise), value(axis, span, at));
}

const PlotCurve* PlotWords::curve(std::size_t series) const {
    return series < plot_->curves.size() ? &plot_->curves[series] : nullptr;
}

Phrase PlotWords::name_of_curve(std::size_t series) const {
    const std::string& name = plot_->curves[series].name;
    return name.empty() ? phrase("curve {0}", std::to_string(series + 1)) : Phrase(name);
}

Phrase PlotWords::position(double x, double y, double z) const {
    std::vector<Phrase> words = {value_of(plot_->x, frame_.x, "x", x), value_of(plot_->y, frame_.y, "y", y)};
    if (!std::isnan(z)) words.push_back(value_of(plot_->z, frame_.z, phrase("height"), z));
    return row_of(words);
}

Phrase PlotWords::nearest(double x, double y) const {
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
        return phrase("nearest: {0}, {1}, {2}", name_of_mark(*plot_, *at_mark),
                      position(mark.x, mark.y, plot_->spatial ? mark.z : std::nan("")), away(right_of(mark.x), above(mark.y)));
    }
    if (!at_point) return phrase("nearest: nothing");
    const PlotPoint& point = plot_->curves[*at_curve].points[*at_point];
    const std::string number = std::to_string(*at_point + 1), all = std::to_string(plot_->curves[*at_curve].points.size());
    return phrase("nearest: {0}, {1}, {2}",
                  plot_->curves.size() > 1 ? phrase("point {0} of {1} of {2}", number, all, name_of_curve(*at_curve))
                                           : phrase("point {0} of {1}", number, all),
                  position(point.x, point.y, std::nan("")), away(right_of(point.x), above(point.y)));
}

Phrase PlotWords::under_finger(const Announcement& one) const {
    const auto x_is = [&] { return value(plot_->x, frame_.x, one.x); };
    const auto y_is = [&] { return value(plot_->y, frame_.y, one.y); };
    switch (one.felt) {
        case FeltPart::nothing: break;
        case FeltPart::curve: {
            if (curve(one.series) == nullptr) break;
            const bool named = !plot_->curves[one.series].name.empty();
            return named ? phrase("curve {0}", name_of_curve(one.series)) : name_of_curve(one.series);
        }
        case FeltPart::mark: {
            if (one.series >= plot_->marks.size()) break;
            const PlotMark& mark = plot_->marks[one.series];
            return phrase("{0}, {1}", name_of_mark(*plot_, one.series),
                          position(mark.x, mark.y, plot_->spatial ? mark.z : std::nan("")));
        }
        case FeltPart::surface:
            if (one.series >= plot_->surfaces.size()) break;
            return on_surface(one);
        case FeltPart::x_axis: return phrase("{0} axis", name_of(plot_->x, "x"));
        case FeltPart::y_axis: return phrase("{0} axis", name_of(plot_->y, "y"));
        case FeltPart::x_tick: return phrase("{0} axis, tick {1}", name_of(plot_->x, "x"), x_is());
        case FeltPart::y_tick: return phrase("{0} axis, tick {1}", name_of(plot_->y, "y"), y_is());
        case FeltPart::x_grid: return phrase("grid line {0} {1}", name_of(plot_->x, "x"), x_is());
        case FeltPart::y_grid: return phrase("grid line {0} {1}", name_of(plot_->y, "y"), y_is());
    }
    return phrase("nothing");
}

// The slope under the finger, and the axes along which it rises: each with at least two fifths of the other's share, as for eight
// directions.
Phrase PlotWords::on_surface(const Announcement& one) const {
    constexpr double kLevel = 0.05, kGentle = 0.27, kSteep = 1;  // 3, 15 and 45 degrees; ours
    const PlotSurface& surface = plot_->surfaces[one.series];
    const SurfacePlace at = place_on(surface, one.x, one.y);
    const std::string number = plot_->surfaces.size() > 1 ? std::to_string(one.series + 1) : "";
    const std::string& name = surface.name.empty() ? number : surface.name;
    std::vector<Phrase> words = {name.empty() ? phrase("surface") : phrase("surface {0}", name),
                                 value_of(plot_->z, frame_.z, phrase("height"), at.height)};
    // mm upwards for a millimetre along each axis.
    const auto felt = [&](const Axis& axis, const AxisSpan& span, double value, double by) {
        return axis.logarithmic ? by * value * std::log(span.to / span.from) / span.mm : by * (span.to - span.from) / span.mm;
    };
    const double up = frame_.z.mm / (frame_.z.to - frame_.z.from);
    const double x = up * felt(plot_->x, frame_.x, one.x, at.along_x), y = up * felt(plot_->y, frame_.y, one.y, at.along_y);
    const double slope = std::hypot(x, y);
    if (!std::isfinite(at.height + slope)) return row_of(words);
    if (slope < kLevel) {
        words.push_back(phrase("level"));
        return row_of(words);
    }
    words.push_back(slope < kGentle ? phrase("gentle slope") : slope < kSteep ? phrase("slope") : phrase("steep slope"));
    const double narrow = std::tan(std::acos(-1.0) / 8);
    const auto goes = [&](const Axis& axis, const Phrase& otherwise, double by, double other) {
        if (std::abs(by) <= narrow * std::abs(other)) return;
        const Phrase with = name_of(axis, otherwise);
        words.push_back(by > 0 ? phrase("rising with {0}", with) : phrase("falling with {0}", with));
    };
    goes(plot_->x, "x", x, y);
    goes(plot_->y, "y", y, x);
    return row_of(words);
}

Phrase PlotWords::curve_end(const Announcement& one) const {
    const PlotCurve* of = curve(one.series);
    if (of == nullptr || of->points.empty()) return phrase("nothing");
    const PlotPoint &first = of->points.front(), &last = of->points.back();
    const auto distance_to = [&](const PlotPoint& point) {
        return std::hypot(mm_along(plot_->x, frame_.x, point.x) - mm_along(plot_->x, frame_.x, one.x),
                          mm_along(plot_->y, frame_.y, point.y) - mm_along(plot_->y, frame_.y, one.y));
    };
    const bool begins = distance_to(first) < distance_to(last);
    const PlotPoint& end = begins ? first : last;
    if (one.telling == Telling::curve_end)
        return phrase("{0}, {1}", name_of_end(begins, false, of->name), position(end.x, end.y, std::nan("")));
    // A gap makes ends of pieces, after which the curve continues; a bar begins on the ground.
    constexpr double kAtEnd = 1;  // mm
    const bool piece = std::abs(mm_along(plot_->x, frame_.x, end.x) - mm_along(plot_->x, frame_.x, one.x)) > kAtEnd;
    return phrase("{0}, {1}", name_of_end(begins, piece, of->name), position(one.x, one.y, std::nan("")));
}

Phrase PlotWords::extreme(const Announcement& one) const {
    const PlotCurve* of = curve(one.series);
    if (of == nullptr || of->points.empty()) return phrase("nothing");
    const auto lower = [](const PlotPoint& a, const PlotPoint& b) { return a.y < b.y; };
    const bool highest = one.telling == Telling::highest;
    const auto at = highest ? std::max_element(of->points.begin(), of->points.end(), lower)
                            : std::min_element(of->points.begin(), of->points.end(), lower);
    const Phrase where = position(at->x, at->y, std::nan(""));
    return highest ? phrase("highest: {0}", where) : phrase("lowest: {0}", where);
}

Phrase PlotWords::comparison(const Announcement& one) const {
    if (curve(one.series) == nullptr || curve(one.other) == nullptr) return phrase("nothing");
    const double first = height_of_curve(*plot_, *curve(one.series), met(*curve(one.series), one.x));
    const double second = height_of_curve(*plot_, *curve(one.other), met(*curve(one.other), one.x));
    const Phrase ours = name_of_curve(one.series), theirs = name_of_curve(one.other);
    const Phrase one_is = value(plot_->y, frame_.y, first), other_is = value(plot_->y, frame_.y, second);
    const Phrase words =
        phrase("at {0}: {1} {2}, {3} {4}", value_of(plot_->x, frame_.x, "x", one.x), ours, one_is, theirs, other_is);
    if (!std::isfinite(first) || !std::isfinite(second)) return words;
    if (one_is == other_is) return phrase("{0}, the same", words);
    const Phrase& higher = first > second ? ours : theirs;
    if (plot_->y.dates) return phrase("{0}, {1} later", words, higher);
    // A difference is as fine as the axis, not as itself, which a logarithmic axis would take it for.
    const double step = telling_step(frame_.y, plot_->y.logarithmic, std::max(first, second));
    const double largest = plot_->y.logarithmic ? 0 : std::max(std::abs(frame_.y.from), std::abs(frame_.y.to));
    return phrase("{0}, {1} {2} higher", words, higher,
                  with_unit(spoken_number(std::abs(first - second), step, largest), plot_->y));
}

Phrase PlotWords::turn(const Announcement& one) const {
    const Phrase where = position(one.x, one.y, std::nan(""));
    const bool maximum = one.telling == Telling::maximum;
    if (plot_->curves.size() < 2) return maximum ? phrase("maximum, {0}", where) : phrase("minimum, {0}", where);
    const Phrase name = name_of_curve(one.series);
    return maximum ? phrase("maximum of {0}, {1}", name, where) : phrase("minimum of {0}, {1}", name, where);
}

Phrase PlotWords::of(const Announcement& one) const {
    switch (one.telling) {
        case Telling::hush: return {};
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
            if (curve(one.series) == nullptr) return phrase("nothing");
            return turn(one);
        case Telling::let_go: return phrase("let go");
        case Telling::no_curve: return phrase("there is no curve");
        case Telling::no_turn: return phrase("no further maximum or minimum this way; once more goes back");
        case Telling::no_turns: return phrase("this curve has no maximum or minimum");
        case Telling::no_other_curve: return phrase("there is no other curve here");
        case Telling::choice: return phrase(key_of(one.action).name);
    }
    return {};
}

}  // namespace tactics
