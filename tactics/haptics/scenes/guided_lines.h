// SPDX-License-Identifier: Apache-2.0
// The curves of a plot as ways that a finger can be led along: how long they are, where their turns are, and where each is at an
// x. Everything is worked out beforehand, so that a tick asks at a cost that hardly grows with the curves.
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

/// mm that a curve must come down from a maximum, and go up from a minimum, before these are worth a way. What is less is noise
/// to a finger: a fixture leaves it a core of some 0.3 mm to either side, where it pulls with less than the 0.1 N that a hand is
/// taken to feel (simulated/hand.h), and a hand comes back to no better than a third of a millimetre (voice/spoken_value.h).
/// Assumed, not measured on people. Where turns would lie closer than this on the average, along the longer side of the curve, as
/// in a million points of noise, the least is doubled until they do not. The ends of a curve, and of its pieces between gaps, are
/// no turns.
inline constexpr double kLeastTurn = 1;

/// Of felt lines: a curve, or a piece of one, that is a single point is a line without a length. The curves of lines ascend;
/// "with the curve" is in the order of its rows, which is that of x where the rows ascend. Queries allocate nothing; those by
/// place or by x take the logarithm of the points.
class GuidedLines {
public:
    /// `resolution`, mm: the one that the lines were thinned by.
    GuidedLines(const Plot& plot, const PlotFrame& frame, const FeltLines& felt, double resolution);

    bool empty() const noexcept { return starts_.size() < 2; }
    std::size_t curves() const noexcept { return firsts_.empty() ? 0 : firsts_.size() - 1; }
    std::uint32_t curve_of(std::uint32_t line) const noexcept { return curve_[line]; }
    /// The lines of a curve are those from the first up to, and without, the end.
    std::uint32_t first_line(std::size_t curve) const noexcept { return firsts_[curve]; }
    std::uint32_t end_line(std::size_t curve) const noexcept { return firsts_[curve + 1]; }
    bool has_place(std::size_t curve) const noexcept { return firsts_[curve] < firsts_[curve + 1]; }

    double length(std::uint32_t line) const noexcept { return along_[starts_[line + 1] - 1]; }
    Point at(const LinePlace& place) const noexcept;
    /// What leads a finger to `stop` when it has come to that place: there, or in the middle of what no finger tells, the mean of
    /// what is within 1 mm of the longer side of the curve; of less towards the stop and the ends of the line, which are met.
    Point middle_at(const LinePlace& place, const LinePlace& stop) const noexcept;
    /// mm along it for a millimetre along its middle; 1: it has none.
    double winding(std::size_t curve) const noexcept { return winding_[curve]; }
    LinePlace place_of(const Nearness& near) const noexcept;
    /// For a finger that no curve reaches: the nearest of at most 1024 places, spread evenly over all lines.
    LinePlace roughly_nearest(Point finger) const noexcept;
    /// Where the curve is first met at x, mm: of an upright its first end. Nothing: in a gap, or beyond the curve. Of more than
    /// 64 pieces that overlap there, which no function has, the first may be missed.
    std::optional<LinePlace> first_at(std::size_t curve, double x) const noexcept;
    /// The next beyond `from` on its curve, with it or back; nullptr: there is none.
    const CurveTurn* next_turn(const LinePlace& from, bool forward) const noexcept;
    std::span<const CurveTurn> turns(std::size_t curve) const noexcept {
        return {turns_.data() + turn_firsts_[curve], turn_firsts_[curve + 1] - turn_firsts_[curve]};
    }

private:
    struct Piece {
        double low, high;  // x, mm
        std::uint32_t line;
    };
    // Of the points of a line up to this one: the least and the largest x.
    struct Reached {
        double low, high;
    };
    void take_lines(const FeltLines& felt, std::size_t curves);
    void take_samples();
    Point sum_to(std::uint32_t line, double along) const noexcept;
    std::size_t after(const LinePlace& place) const noexcept;
    void place_turns(const PlotCurve& curve, std::size_t index, const PlotFrame& frame, double resolution);
    std::optional<LinePlace> place_on(std::uint32_t line, Point point, double within, std::size_t& from) const;

    std::vector<Point> points_;  // of all lines
    std::vector<double> along_;
    std::vector<Reached> reached_;
    std::vector<std::size_t> starts_;   // of each line, its first point
    std::vector<std::uint32_t> curve_;  // of each line
    std::vector<std::uint32_t> firsts_;
    std::vector<Point> sums_;      // of each point: the integral of the line up to it, mm^2
    std::vector<double> winding_;  // of each curve
    std::vector<Piece> pieces_;    // as the lines, but those of a curve by their least x
    struct Sample {
        LinePlace place;
        Point at;
    };
    std::vector<Sample> samples_;
    std::vector<CurveTurn> turns_;
    std::vector<std::size_t> turn_firsts_;
};

}  // namespace tactics
