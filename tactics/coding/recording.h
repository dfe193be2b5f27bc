// SPDX-License-Identifier: Apache-2.0
// Recordings of what was felt, in the container: where a finger was and what pushed it, tick by tick.
//
// Facts of the kind "recording" (56 bytes), then a part for each 4096 ticks:
//     0   4   ticks
//     4   1   how forces are guessed: 0 hold, 1 linear
//     5   1   bit 0: the finger's height is told; bit 1: forces have all three directions, else only that upwards
//     6   2   0
//     8   8   step of places, mm      16   8   step of forces, N (IEEE 754 doubles, all of them)
//    24   8   deadband, of the force  32   8   its floor, N      40   8   work that may be given out too much, N mm
//    48   8   time of the first tick, microseconds (a whole number with sign)
// A part is the time of its first tick, 8 bytes, and decisions of binary_coder.h: for each tick the change of its step of time,
// the change of its step of place, and whether its force is told; where it is, by how much the guess misses it and, if linear,
// its slope. Places and times are told exactly in their steps, forces as deadband.h says.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tactics/coding/container.h"
#include "tactics/coding/deadband.h"

namespace tactics {

inline constexpr std::size_t kMostTicks = 10'000'000;
inline constexpr std::size_t kTicksOfPart = 4096;

struct Recording {
    double place_step = 1e-4;              ///< mm
    double force_step = 1e-4;              ///< N
    bool has_height = false;               ///< else z of all places is 0
    bool spatial = false;                  ///< else x and y of all forces are 0
    std::vector<std::int64_t> times = {};  ///< microseconds, never back
    std::vector<Steps3> places = {}, forces = {};
};

/// Weber's deadband in N and N mm; none: every force is told.
struct ForceBand {
    double share = 0;      ///< of the true force, 0 to 0.5
    double floor = 0;      ///< N
    double allowance = 0;  ///< N mm
    ForceGuess guess = ForceGuess::hold;
};

struct EncodedRecording {
    std::string bytes;
    std::size_t told = 0;  ///< forces
};

/// Of at least one tick and at most kMostTicks; times and steps of places below 2^44, steps of forces below 2^34.
EncodedRecording encode_recording(const Recording& recording, const ForceBand& band);

/// What a deadband did to forces.
struct ForceLoss {
    double rms = 0, most = 0;  ///< N, by how much they are missed
    double of_threshold = 0;   ///< the most of what was allowed at its tick: at most 1
    double work = 0;           ///< N mm that they give out too much, over the worst stretch
    std::size_t touched = 0;   ///< ticks with a force
};
/// Of recordings of the same ticks and steps.
ForceLoss loss_of(const Recording& truth, const Recording& decoded, const ForceBand& band);

/// What the head tells.
struct RecordingFacts {
    std::size_t ticks = 0;
    double place_step = 0, force_step = 0;
    bool has_height = false, spatial = false;
    ForceBand band;
};
/// Throws Error(failed) if it is no recording, or a fact is none that there can be.
RecordingFacts recording_facts(const Container& container);
/// Whole.
Recording decode_recording(const Container& container);
/// The ticks from `from` to `to` microseconds, of those parts that have them; perhaps none.
Recording decode_recording(const Container& container, std::int64_t from, std::int64_t to);

}  // namespace tactics
