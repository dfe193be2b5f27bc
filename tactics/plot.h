// SPDX-License-Identifier: Apache-2.0
// Data for a tactile chart: points, curves and surfaces over their axes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tactics {

struct Axis {
    std::string name;          ///< with its unit: "time for a picture, ms"
    bool logarithmic = false;  ///< all values must be over 0
    bool dates = false;        ///< values are seconds since 1970-01-01 00:00 UTC
    bool downwards = false;    ///< for a y axis: values grow downwards, as distances towards the reader do, seen from above
    bool comma = false;        ///< its numbers are written 0,5 and not 0.5
};

/// Kinds that a finger can tell apart: five are the most in a key (TACTILE: at most five point symbols).
enum class PlotSymbol : std::uint8_t { disc, ring, square, triangle, cross };
inline constexpr int kSymbols = 5;

/// One data point.
struct PlotMark {
    std::string name;  ///< empty: no letter and no line in the key
    double x = 0;
    double y = 0;
    PlotSymbol symbol = PlotSymbol::disc;
    double z = 0;  ///< upwards, in a spatial plot
};

struct PlotPoint {
    double x = 0;
    double y = 0;
};

/// How a curve runs from one point to the next.
enum class Joining : std::uint8_t {
    straight,
    steps,  ///< level from a point to the next point's x, then up or down
    bars,   ///< as steps, each a bar on 0: a histogram, whose last point ends the last bar
};

struct PlotCurve {
    std::string name;  ///< empty: it needs no line in the key
    std::vector<PlotPoint> points;
    Joining joined = Joining::straight;
    std::vector<std::size_t> gaps = {};  ///< ascending indices of points to which no line leads, because values before them are
                                         ///< unknown
};

/// Heights over a grid, which need not be evenly spaced.
struct PlotSurface {
    std::string name;          ///< empty: it needs no line in the key
    std::vector<double> x, y;  ///< ascending, at least two each
    std::vector<double> z;     ///< one row for each y; NaN where unknown

    double at(std::size_t column, std::size_t row) const { return z[row * x.size() + column]; }
};

/// The range of error of a value: from `low` to `high`, on the same axis. NaN: unknown.
struct PlotRange {
    double low = 0;
    double high = 0;
};

/// One bar, or one part of a stack of bars, for each category.
struct PlotSeries {
    std::string name;                    ///< empty if there is only one
    std::vector<double> values;          ///< one for each category; NaN: unknown
    std::vector<PlotRange> errors = {};  ///< one for each value; empty: none
};

/// Which way bars run from their axis.
enum class BarWay : std::uint8_t {
    automatic,  ///< upwards if the names of the categories have room below the bars, else to the right
    upright,
    level,
};

/// Bars over categories. The axis of their values always includes 0, where each bar begins.
struct PlotBars {
    std::vector<std::string> categories;
    std::vector<PlotSeries> series;  ///< at most kMostSeries
    bool stacked = false;            ///< series stand on each other; negative values go down from 0
    BarWay way = BarWay::automatic;
};
inline constexpr std::size_t kMostSeries = 5;  // textures that a finger can tell apart (BANA Guidelines 3.2.2)

/// All values are finite, except unknown values of a surface or a bar.
struct Plot {
    std::string title;
    Axis x;
    Axis y;
    std::vector<PlotCurve> curves;
    std::vector<PlotMark> marks;
    Axis z = {};  ///< upwards, for surfaces and for the marks of a spatial plot
    std::vector<PlotSurface> surfaces = {};
    bool spatial = false;               ///< its marks have a z
    std::optional<PlotBars> bars = {};  ///< if present, nothing else is drawn: `x` is the category axis, `y` the value axis
};

}  // namespace tactics
