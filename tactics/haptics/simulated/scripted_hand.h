// SPDX-License-Identifier: Apache-2.0
// What the scripted hands have in common (hand.h): when and how faintly they feel, how far they lead their finger, what they find
// and which keys they press.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "tactics/haptics/simulated/hand.h"

namespace tactics {

inline constexpr double kFelt = 0.1;          ///< N; less is not felt
inline constexpr double kPress = 1.5;         ///< mm by which a hand is inside a wall: about half a newton
inline constexpr double kBesideSolid = 0.08;  ///< of a solid, at whose sides a hand that presses on it would slip off

inline double flat_length(const Point3& v) noexcept { return std::hypot(v.x, v.y); }
inline Point3 flat(const Point3& v) noexcept { return {v.x, v.y, 0}; }

/// What has been felt by now of all that happened so far, and where.
class LateSense {
public:
    HandSense feel(const HandSense& sense, double dt) noexcept;

private:
    std::array<HandSense, 2048> past_{};
    std::size_t now_ = 0;
    HandSense smooth_;
};

class ScriptedHand : public Hand {
public:
    explicit ScriptedHand(const HandField& field);
    Point3 move(const HandSense& sense, double dt) noexcept final;
    const std::vector<HandFinding>& findings() const noexcept final { return findings_; }
    bool is_done() const noexcept final { return done_; }
    unsigned keys() const noexcept final { return time_ < pressed_until_ ? pressed_ : 0; }

protected:
    virtual void go(double dt) noexcept = 0;
    void find(std::string_view what) noexcept { find(what, finger_); }
    void find(std::string_view what, const Point3& place) noexcept;
    void press_key(unsigned key) noexcept;
    void go_towards(const Point3& goal, double speed, double dt) noexcept;
    /// Downwards on a solid, over which it then goes: about a newton, less on a steep place, as it would not get up there else,
    /// and not below its foot.
    void press(double dt) noexcept;
    void next() noexcept { ++phase_, in_phase_ = 0; }

    HandField field_;
    Point3 at_, finger_, force_;
    Point3 felt_at_;  // where the force was that is felt by now
    double time_ = 0, in_phase_ = 0;
    int phase_ = 0;
    bool done_ = false;

private:
    bool begun_ = false;
    unsigned pressed_ = 0;
    double pressed_until_ = 0;
    LateSense late_;
    std::vector<HandFinding> findings_;
};

/// Finds a curve from the axes, follows it to its end and stops at a tick.
std::unique_ptr<Hand> trace_hand(const HandField& field);
/// Presses on a surface along two lines through its middle and notes heights.
std::unique_ptr<Hand> sections_hand(const HandField& field);

}  // namespace tactics
