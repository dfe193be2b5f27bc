// SPDX-License-Identifier: Apache-2.0
// The results of a play, in figures and as a plot.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tactics/haptics/loop/play_loop.h"
#include "tactics/haptics/scenes/relief_surface.h"
#include "tactics/haptics/scenes/stability.h"
#include "tactics/plot.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct PlayFigures {
    ForceLaw law;
    std::size_t ticks = 0;
    double seconds = 0;
    double way = 0;         ///< mm, of the finger over the map
    double touched = 0;     ///< share of the ticks with a force
    double most_force = 0;  ///< N
    double most_over = 0;   ///< greatest height of the fingertip over the surface, mm
    double most_under = 0;  ///< greatest depth in the surface, mm
    bool real = false;      ///< in real time, so that lateness is meaningful
    bool before_others = false;
    double late_p50 = 0, late_p99 = 0, late_p999 = 0;  ///< s
    std::uint64_t long_periods = 0;
    double update_p50 = 0, update_p999 = 0;  ///< s that the scene took to answer in a tick
    std::optional<double> place_error;       ///< mm, root of the mean square while it moved, where the truth is known
    unsigned not_finite = 0, too_late = 0, resets = 0, gone = 0, reports_lost = 0;
};

/// `updates`: the time of the scene in each tick.
PlayFigures figures_of(const std::vector<TickRecord>& records, const PlayLoopReport& played, const Playing& play,
                       const ForceLaw& law, const Lateness& updates, unsigned resets, bool before_others, bool real);
std::vector<Phrase> figure_lines(const PlayFigures& figures, bool lost);
std::string figures_json(const PlayFigures& figures);

/// Height against place: the whole path of the fingertip, and the surface where it is not too close to that; against the length
/// of the path if the hand turned round. For a hand that `repeats` its path, only the first pass; optionally only a part of the
/// map (from and to, mm). Throws Error(usage) if no path is in that part.
Plot way_plot(const std::vector<TickRecord>& records, const ReliefSurface& map, std::optional<Point> part, bool repeats);
/// Place against time on the last pass: the true place of the fingertip and the mouse's estimate (1-DOF haptic mouse, figures 8
/// and
/// 9).
Plot track_plot(const std::vector<TickRecord>& records);
/// The requested setting, and the largest stable stiffness against damping for each finger.
struct StableFigures {
    ForceLaw law;
    LeverSettings lever;
    bool stable = false;
    std::vector<StablePoint> border;
};
/// `stable`: the result of check_stable for the law.
StableFigures stable_figures(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers,
                             bool stable);
Plot stable_plot(const StableFigures& figures);
std::string stable_json(const StableFigures& figures);

}  // namespace tactics
