// SPDX-License-Identifier: Apache-2.0
// An announcement about a plot, as plain values: the loop passes it on, and another thread makes the words.
#pragma once

#include <cstdint>
#include <limits>

#include "tactics/haptics/voice/plot_keys.h"

namespace tactics {

enum class Telling : std::uint8_t {
    hush,          ///< ends the current speech
    position,      ///< where the finger is
    nearest,       ///< the data point nearest to it
    under_finger,  ///< `felt`
    curve_end,     ///< of the curve `series`, whichever end is nearer
    highest,       ///< data point of the curve `series`
    lowest,
    comparison,  ///< of the curves `series` and `other` at x
    way_end,     ///< the finger was led to an end of the curve `series`, or of a piece of it,
    maximum,     ///< or to a turn of it
    minimum,
    let_go,          ///< a led finger was released
    no_curve,        ///< why it cannot be led: there is no curve,
    no_turn,         ///< no further maximum or minimum,
    no_turns,        ///< none on the whole curve,
    no_other_curve,  ///< no other curve at this x
    choice,          ///< the name of `action`
};

enum class FeltPart : std::uint8_t { nothing, curve, mark, surface, x_axis, y_axis, x_tick, y_tick, x_grid, y_grid };

struct Announcement {
    Telling telling = Telling::position;
    FeltPart felt = FeltPart::nothing;                    ///< for under_finger; for a tick or a grid line, x or y is its value
    std::uint32_t series = 0;                             ///< index of the plot's curve, mark or surface
    std::uint32_t other = 0;                              ///< other curve, for comparison
    PlotAction action = PlotAction::chosen;               ///< for choice
    double x = 0, y = 0;                                  ///< plot coordinates
    double z = std::numeric_limits<double>::quiet_NaN();  ///< NaN: unspecified
};

}  // namespace tactics
