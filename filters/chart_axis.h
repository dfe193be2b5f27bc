// SPDX-License-Identifier: Apache-2.0
// An axis of a chart: from values to millimetres, and what is written at its ticks.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "filters/ticks.h"
#include "tactics/plot.h"

namespace tactics {

inline constexpr int kFewestTicks = 3, kMostAxisTicks = 6;  // an axis

/// From the least to the largest of the values that it took.
struct AxisExtent {
    double low = INFINITY, high = -INFINITY;

    void take(double value) {
        low = value < low ? value : low;
        high = value > high ? value : high;
    }
    bool holds_any() const { return low <= high; }
};

/// Ticks with their words.
struct AxisTicks {
    Ticks ticks;
    std::vector<std::string> words;  ///< one each
    std::string since = {};          ///< of dates: the day to which times of day belong
};
AxisTicks axis_ticks(const Axis& axis, const AxisExtent& extent, int most);
/// Two: of dates the ends of the extent, of numbers the outer ones of as few round values as there may be.
AxisTicks axis_ends(const Axis& axis, const AxisExtent& extent);

class AxisScale {
public:
    AxisScale(const Axis& axis, const AxisExtent& extent, int most_ticks, double from, double to)
        : AxisScale(axis, axis_ticks(axis, extent, most_ticks), from, to) {}
    AxisScale(const Axis& axis, AxisTicks ticks, double from, double to)
        : logarithmic_(axis.logarithmic && !axis.dates),
          ticks_(std::move(ticks)),
          before_(ticks_.words.size(), 0.5),
          from_(from),
          to_(to) {}

    double at(double value) const {
        const double first = bent(ticks_.ticks.low), last = bent(ticks_.ticks.high);
        return from_ + (bent(value) - first) / (last - first) * (to_ - from_);
    }
    const std::vector<double>& ticks() const { return ticks_.ticks.at; }
    const std::vector<std::string>& words() const { return ticks_.words; }
    /// The share of each one's words that lies before its tick: half of them, unless they were moved.
    const std::vector<double>& before() const { return before_; }
    double low() const { return ticks_.ticks.low; }
    AxisPlace place() const { return {ticks_.ticks.low, ticks_.ticks.high, from_, to_}; }
    /// Only the first and the last of them stay.
    void keep_ends();
    /// The words of two ticks do not stand in the middle below them: `first` and `last` of them lie before these.
    void move_words(double first, double last) {
        before_ = {first, last};
        moved_ = true;
    }
    bool moved() const { return moved_; }

private:
    double bent(double value) const { return logarithmic_ ? std::log10(value) : value; }
    bool logarithmic_;
    AxisTicks ticks_;
    std::vector<double> before_;
    bool moved_ = false;
    double from_, to_;
};

/// A number as the axis writes it: 0.5, or 0,5.
std::string number_text(const Axis& axis, double value);

/// A value of the axis as words tell it: "height = 3 m" of "height (m)" or "height, m".
std::string told_value(const Axis& axis, double value);

}  // namespace tactics
