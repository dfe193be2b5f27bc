// SPDX-License-Identifier: Apache-2.0
// What came of a play, in figures and as a plot.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tactics/haptics/loop/play_loop.h"
#include "tactics/haptics/scenes/relief_surface.h"
#include "tactics/haptics/scenes/stability.h"
#include "tactics/plot.h"

namespace tactics {

struct PlayFigures {
    ForceLaw law;
    std::size_t ticks = 0;
    double seconds = 0;
    double way = 0;         ///< mm, of the finger over the map
    double touched = 0;     ///< share of the ticks with a force
    double most_force = 0;  ///< N
    double most_over = 0;   ///< mm, of the fingertip over the surface that it was lifted by
    double most_under = 0;  ///< mm, that it sank into it
    bool real = false;      ///< by the clock on the wall: then lateness means something
    bool before_others = false;
    double late_p50 = 0, late_p99 = 0, late_p999 = 0;  ///< s
    std::uint64_t long_periods = 0;
    double update_p50 = 0, update_p999 = 0;  ///< s that what is felt took to answer in a tick
    std::optional<double> place_error;       ///< mm, root of the mean square while it moved, where the truth is known
    unsigned not_finite = 0, too_late = 0, resets = 0, gone = 0, reports_lost = 0;
};

/// `updates`: of each tick what its scene took.
PlayFigures figures_of(const std::vector<TickRecord>& records, const PlayLoopReport& played, const Playing& play,
                       const ForceLaw& law, const Lateness& updates, unsigned resets, bool before_others, bool real);
std::vector<std::string> figure_lines(const PlayFigures& figures, bool lost);
std::string figures_json(const PlayFigures& figures);

/// Height over place: the fingertip, whole, and the surface where it is not too near to that; over the length of the way where
/// the hand turned round. Of a hand that `repeats` its way, the first from one side to the other; of any, that on a part of the
/// map (from and to, mm). Throws Error(usage): nothing of the way is in that part.
Plot way_plot(const std::vector<TickRecord>& records, const ReliefSurface& map, std::optional<Point> part, bool repeats);
/// Place over time on the last way: where the fingertip was, and where the mouse took it to be (1-DOF haptic mouse, figures 8 and
/// 9).
Plot track_plot(const std::vector<TickRecord>& records);
/// What is asked for, and over damping the most stiffness that comes to rest with each of the fingers.
struct StableFigures {
    ForceLaw law;
    LeverSettings lever;
    bool stable = false;
    std::vector<StablePoint> border;
};
/// `stable`: what check_stable says of the law.
StableFigures stable_figures(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers,
                             bool stable);
Plot stable_plot(const StableFigures& figures);
std::string stable_json(const StableFigures& figures);

}  // namespace tactics
