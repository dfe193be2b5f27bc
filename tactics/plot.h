// SPDX-License-Identifier: Apache-2.0
// Data to be felt: points, curves and surfaces over their axes.
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
    bool downwards = false;    ///< of a y: its values grow downwards, as a way towards the reader does, seen from above
    bool comma = false;        ///< its numbers are written 0,5 and not 0.5
};

/// What a finger tells apart: five are the most that a key needs (TACTILE: at most five point symbols).
enum class PlotSymbol : std::uint8_t { disc, ring, square, triangle, cross };
inline constexpr int kSymbols = 5;

/// One thing that was measured.
struct PlotMark {
    std::string name;  ///< empty: it has no letter and no line in the key
    double x = 0;
    double y = 0;
    PlotSymbol symbol = PlotSymbol::disc;
    double z = 0;  ///< upwards, of a spatial plot
};

struct PlotPoint {
    double x = 0;
    double y = 0;
};

/// How a curve goes from one point to the next.
enum class Joining : std::uint8_t {
    straight,
    steps,  ///< level from its point to the next one's x, then up or down
    bars,   ///< as steps, and each stands on 0: a histogram, whose last point ends the last bar
};

struct PlotCurve {
    std::string name;  ///< empty: it needs no line in the key
    std::vector<PlotPoint> points;
    Joining joined = Joining::straight;
    std::vector<std::size_t> gaps = {};  ///< ascending: no line leads to the point of that index, as nothing is known before it
};

/// Heights over a grid, not evenly spaced perhaps.
struct PlotSurface {
    std::string name;          ///< empty: it needs no line in the key
    std::vector<double> x, y;  ///< ascending, at least two each
    std::vector<double> z;     ///< a row for each y; NaN where nothing is known

    double at(std::size_t column, std::size_t row) const { return z[row * x.size() + column]; }
};

/// How far a value may be off: from `low` to `high`, which are values of the same axis. NaN: nothing is known.
struct PlotRange {
    double low = 0;
    double high = 0;
};

/// One bar, or one part of a stack of bars, for each category.
struct PlotSeries {
    std::string name;                    ///< empty if there is only one
    std::vector<double> values;          ///< one for each category; NaN: nothing is known
    std::vector<PlotRange> errors = {};  ///< one for each value; empty: none
};

/// Which way bars run from their axis.
enum class BarWay : std::uint8_t {
    automatic,  ///< upwards if the names of the categories have room below the bars, else to the right
    upright,
    level,
};

/// Bars over categories. The axis of their values always holds 0, where each bar begins.
struct PlotBars {
    std::vector<std::string> categories;
    std::vector<PlotSeries> series;  ///< at most kMostSeries
    bool stacked = false;            ///< series stand on each other; negative values go down from 0
    BarWay way = BarWay::automatic;
};
inline constexpr std::size_t kMostSeries = 5;  // textures that a finger tells apart (BANA Guidelines 3.2.2)

/// All values are finite but for what is not known of a surface or a bar.
struct Plot {
    std::string title;
    Axis x;
    Axis y;
    std::vector<PlotCurve> curves;
    std::vector<PlotMark> marks;
    Axis z = {};  ///< upwards, of surfaces and of the marks of a spatial plot
    std::vector<PlotSurface> surfaces = {};
    bool spatial = false;               ///< its marks have a z
    std::optional<PlotBars> bars = {};  ///< if present, nothing else is drawn: `x` is the axis of categories, `y` that of values
};

}  // namespace tactics
