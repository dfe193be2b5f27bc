// SPDX-License-Identifier: Apache-2.0
// How much is in a recording of forces: each component as a grid of one row, a tick after the other.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "tactics/coding/recording.h"
#include "tactics/information/channel.h"
#include "tactics/information/measures.h"

namespace tactics {

struct MeasuredStream {
    double seconds = 0;
    std::size_t ticks = 0;
    int levels = 0;                      ///< of each component, from -most to most
    double most = 0;                     ///< N
    std::array<Measures, 3> along = {};  ///< to the right, down, upwards
    double low = 0, bits = 0, high = 0;  ///< of all three, as Measures has them
    /// Ticks of which a force must be told so that a hand feels no difference, by a deadband of a tenth, held
    /// (coding/deadband.h).
    std::size_t felt = 0;
};

/// The forces in the recording's own steps, or in the finest of 65,535 levels. Throws Error(failed): fewer than two ticks, or no
/// force in any. `name` is the file's, for messages.
MeasuredStream measured(const Recording& recording, std::string_view name);

/// What a machine that pushes back tells of it: forces cut at the most it gives, in steps that a finger notes (kLeastForce).
struct CarriedForces {
    int levels = 0;
    double bits = 0;
    double loss = 0;      ///< max(H - C, 0) / H, of MeasuredStream::bits
    std::size_t cut = 0;  ///< ticks with a force beyond what it gives
};
inline constexpr double kLeastForce = 0.01;  ///< N, that a finger notes on an arm; ours, the floor of a deadband

/// Throws std::logic_error for a channel that does not push back.
CarriedForces carried_by(const Recording& recording, const MeasuredStream& stream, const MediumChannel& channel);

}  // namespace tactics
