// SPDX-License-Identifier: Apache-2.0
// What is to be told of a plot, as plain values: the loop hands it over, and words are made elsewhere.
#pragma once

#include <cstdint>
#include <limits>

#include "tactics/haptics/voice/plot_keys.h"

namespace tactics {

enum class Telling : std::uint8_t {
    hush,          ///< nothing more: what is spoken ends
    position,      ///< where the finger is
    nearest,       ///< the data point nearest to it
    under_finger,  ///< `felt`
    curve_end,     ///< of the curve `series`, whichever end is nearer
    highest,       ///< data point of the curve `series`
    lowest,
    comparison,  ///< of the curves `series` and `other` at x
    way_end,     ///< where the finger was led: to an end of the curve `series`, or of a piece of it,
    maximum,     ///< or to a turn of it
    minimum,
    let_go,          ///< a finger was led and is no longer
    no_curve,        ///< why it cannot be led: there is none,
    no_turn,         ///< no further maximum or minimum,
    no_turns,        ///< none on the whole curve,
    no_other_curve,  ///< no other curve at this x
    choice,          ///< the name of `action`
};

enum class FeltPart : std::uint8_t { nothing, curve, mark, surface, x_axis, y_axis, x_tick, y_tick, x_grid, y_grid };

struct Announcement {
    Telling telling = Telling::position;
    FeltPart felt = FeltPart::nothing;                    ///< of under_finger; of a tick or a grid line, x or y is its value
    std::uint32_t series = 0;                             ///< which of the plot's curves, marks or surfaces
    std::uint32_t other = 0;                              ///< curve, of comparison
    PlotAction action = PlotAction::chosen;               ///< of choice
    double x = 0, y = 0;                                  ///< plot coordinates
    double z = std::numeric_limits<double>::quiet_NaN();  ///< not a number: not told
};

}  // namespace tactics
