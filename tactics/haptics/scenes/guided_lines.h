// SPDX-License-Identifier: Apache-2.0
// The curves of a plot as paths for guidance: their lengths, their turns, and their places at a given x. Everything is computed
// in advance, so that the cost of a query in a tick hardly grows with the curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tactics/haptics/scenes/near_lines.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/plot.h"

namespace tactics {

/// A place on a line.
struct LinePlace {
    std::uint32_t line = 0;
    double along = 0;  ///< mm from the line's first point
    bool operator==(const LinePlace&) const = default;
};

/// A local maximum or minimum of a curve.
struct CurveTurn {
    LinePlace at;
    PlotPoint value;  ///< the data point itself
    bool highest = false;
};

/// mm by which a curve must fall from a maximum, or rise from a minimum, to make it a destination. Smaller turns are noise to a
/// finger: a fixture leaves a core of some 0.3 mm on either side, where it pulls with less than the 0.1 N that a hand is assumed
/// to feel (simulated/hand.h), and a hand returns to a place within a third of a millimetre at best (voice/spoken_value.h).
/// Assumed, not measured on people. If turns would on average be closer than this along the longer side of the curve, as in a
/// million points of noise, the threshold is doubled until they are not. The ends of a curve, and of its pieces between gaps, are
/// no turns.
inline constexpr double kLeastTurn = 1;

/// Built from felt lines: a curve, or a piece of one, with a single point is a line without length. The curve indices of lines
/// ascend; "with the curve" means in the order of its rows, which is that of x if the rows ascend. Queries allocate nothing;
/// those by place or by x take time logarithmic in the points.
class GuidedLines {
public:
    /// `resolution`, mm: the one by which the lines were thinned.
    GuidedLines(const Plot& plot, const PlotFrame& frame, const FeltLines& felt, double resolution);

    bool empty() const noexcept { return starts_.size() < 2; }
    std::size_t curves() const noexcept { return firsts_.empty() ? 0 : firsts_.size() - 1; }
    std::uint32_t curve_of(std::uint32_t line) const noexcept { return curve_[line]; }
    /// The lines of a curve are those from the first up to, but not including, the end.
    std::uint32_t first_line(std::size_t curve) const noexcept { return firsts_[curve]; }
    std::uint32_t end_line(std::size_t curve) const noexcept { return firsts_[curve + 1]; }
    bool has_place(std::size_t curve) const noexcept { return firsts_[curve] < firsts_[curve + 1]; }

    double length(std::uint32_t line) const noexcept { return along_[starts_[line + 1] - 1]; }
    Point at(const LinePlace& place) const noexcept;
    /// The leading point for a finger at that place on its way to `stop`: the place itself, or the middle of noise too fine for a
    /// finger, which is the mean within 1 mm along the longer side of the curve; the range shrinks towards the stop and the ends
    /// of the line, which are reached exactly.
    Point middle_at(const LinePlace& place, const LinePlace& stop) const noexcept;
    /// mm along the curve per millimetre along its smoothed middle; 1: no noise.
    double winding(std::size_t curve) const noexcept { return winding_[curve]; }
    LinePlace place_of(const Nearness& near) const noexcept;
    /// For a finger out of reach of all curves: the nearest of at most 1024 places, spread evenly over all lines.
    LinePlace roughly_nearest(Point finger) const noexcept;
    /// The place where the curve is first met at x, mm; for a vertical side, its first end. Nothing: in a gap, or beyond the
    /// curve. If more than 64 pieces overlap there, which does not happen for a function, the first may be missed.
    std::optional<LinePlace> first_at(std::size_t curve, double x) const noexcept;
    /// The next turn after `from` on its curve, forwards or backwards; nullptr: there is none.
    const CurveTurn* next_turn(const LinePlace& from, bool forward) const noexcept;
    std::span<const CurveTurn> turns(std::size_t curve) const noexcept {
        return {turns_.data() + turn_firsts_[curve], turn_firsts_[curve + 1] - turn_firsts_[curve]};
    }

private:
    struct Piece {
        double low, high;  // x, mm
        std::uint32_t line;
    };
    // The smallest and the largest x of a line's points up to this one.
    struct Reached {
        double low, high;
    };
    void take_lines(const FeltLines& felt, std::size_t curves);
    void take_samples();
    Point sum_to(std::uint32_t line, double along) const noexcept;
    std::size_t after(const LinePlace& place) const noexcept;
    void place_turns(const PlotCurve& curve, std::size_t index, const PlotFrame& frame, double resolution);
    std::optional<LinePlace> place_on(std::uint32_t line, Point point, double within, std::size_t& from) const;

    std::vector<Point> points_;  // points of all lines
    std::vector<double> along_;
    std::vector<Reached> reached_;
    std::vector<std::size_t> starts_;   // index of each line's first point
    std::vector<std::uint32_t> curve_;  // of each line
    std::vector<std::uint32_t> firsts_;
    std::vector<Point> sums_;      // for each point, the integral of the line up to it, mm^2
    std::vector<double> winding_;  // for each curve
    std::vector<Piece> pieces_;    // like the lines, but sorted by least x within a curve
    struct Sample {
        LinePlace place;
        Point at;
    };
    std::vector<Sample> samples_;
    std::vector<CurveTurn> turns_;
    std::vector<std::size_t> turn_firsts_;
};

}  // namespace tactics
