// SPDX-License-Identifier: Apache-2.0
// Which forces of a recording need to be told, so that a hand feels no difference: Weber's law on forces of any direction.
//
// A receiver guesses the force of each tick from what it was told last. The sender knows what it guesses, and tells anew only
// where the guess leaves a ball around the true force, and then, as a recording has the forces that follow, what stays in their
// balls for longest (P. Hinterseer, S. Hirche, S. Chaudhuri, E. Steinbach and M. Buss,
// "Perception-based data reduction and transmission of haptic data in telepresence and teleaction systems", IEEE Trans. Signal
// Processing 56, 2008), or where the receiver would give out more work than the recording does.
//
// Work. The force of a tick acts until the next, over the way from its place to the next one's. What a guess adds is the work of
// the guessed force less that of the true one. The sender keeps the most that has been added from any tick until now, which is
// that of the tick before, or 0 if that is less, and what this tick adds. Where it would come over `allowance`, the true force
// itself is told, which adds nothing, unless another keeps to that, too. So over no stretch of a recording, wherever it begins
// and ends, the decoded forces give out more than `allowance` beyond what the true ones do.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tactics {

/// Of force or of place, in steps of the recording.
struct Steps3 {
    std::int64_t x = 0, y = 0, z = 0;
    bool operator==(const Steps3&) const = default;
};

enum class ForceGuess : unsigned char {
    hold = 0,    ///< as it was told
    linear = 1,  ///< on the straight line that was told
};

/// What makes no difference.
struct Deadband {
    double share = 0;      ///< of the true force: 0.1 for a tenth
    double floor = 0;      ///< steps of force: of weak forces so much, whatever its share
    double allowance = 0;  ///< steps of force times steps of place: work that the guesses may give out too much
    ForceGuess guess = ForceGuess::hold;
};

/// What the receiver is told at a tick.
struct ForceTold {
    Steps3 force;
    Steps3 slope;  ///< 1/256 of a step a tick; none with hold
};

/// The receiver's guess, in whole numbers, so that both sides have the same.
class GuessedForce {
public:
    void tell(const ForceTold& told) noexcept {
        told_ = told;
        since_ = 0;
    }
    void tick() noexcept { ++since_; }  ///< a tick later
    Steps3 now() const noexcept;

private:
    ForceTold told_;
    std::int64_t since_ = 0;
};

struct ToldAt {
    std::size_t tick = 0;
    ForceTold told;
};
/// For one part, from its first tick on: what is told at which tick, in their order; the first always is. `places` has a place
/// for each force and, where the recording goes on, the next one's. `added` is the work added before the part, and then behind
/// it.
std::vector<ToldAt> forces_told(std::span<const Steps3> forces, std::span<const Steps3> places, const Deadband& deadband,
                                double& added);

}  // namespace tactics
