// SPDX-License-Identifier: Apache-2.0
// A plot that takes a finger by the hand: to where a curve begins, along it, to its next turn, over to another curve.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tactics/haptics/scenes/guided_lines.h"
#include "tactics/haptics/scenes/scene.h"

namespace tactics {

/// Where a finger can be led.
enum class LeadTo : std::uint8_t {
    start,     ///< to the beginning of the nearest curve; from there, or asked once more, to that of the next
    follow,    ///< along the curve to its end; from there, or asked once more, back
    extremum,  ///< along the curve to its next turn; behind the last the way turns round
    compare,   ///< straight to the next curve that has a value at the same x
};

enum class LeadEnd : std::uint8_t {
    arrived,
    resisted,  ///< the finger stood still for a second against what led it
    left,      ///< it went away from the way by itself
    stopped,   ///< it was let go of, or led elsewhere
};

/// A way that a finger is led.
struct LeadGoal {
    LeadTo lead = LeadTo::start;
    std::uint32_t curve = 0;  ///< of the plot, to which it leads
    std::uint32_t from = 0;   ///< compare: the curve that it leaves
    PlotPoint value;          ///< of where it ends; compare: x is that of both
    bool highest = false;     ///< extremum: a maximum
    Point place;              ///< mm, where it ends
};

/// One that is over.
struct LeadRecord {
    LeadGoal goal;
    LeadEnd end = LeadEnd::arrived;
    std::size_t from = 0, to = 0;  ///< ticks since the guidance was made
    double off = 0;                ///< mm between the finger and the place when it ended
};

struct GuidanceSettings {
    double most_force = 0.8;      ///< N
    double stiffness = 0.5;       ///< N/mm, of the spring between the finger and what it is led by
    double damping_ns_per_m = 1;  ///< of the finger while it is led
};

/// For an arm of that greatest force under that law: no more than a newton, nor a quarter of the arm's; no stiffer than the law,
/// nor so stiff that what leads is less than 1.6 mm ahead.
GuidanceSettings guidance_for(double most_force, double stiffness, double damping_ns_per_m);

/// Goes between a plot's scene and what listens to keys. A point runs ahead of the finger at 40 mm/s, as the simulated hands
/// trace (along the middle of noise that no finger tells), and draws it by a spring; it waits for a finger that lags, and lets go
/// of one that stands still for a second, that goes away by more than 5 mm, or that has arrived: 0.3 mm from where it leads. What
/// leads begins where the finger is, so that its force begins with none, and never has more than `most_force` in all; a finger
/// that friction holds back before the goal is drawn by more and more of that. Nothing pulls a finger off the plane z = 0 or into
/// it; one that is above it is drawn down to it, too.
///
/// On its way along a curve everything is felt as ever. While it is carried beside curves (to a beginning, over a gap, to another
/// curve) what the plot gives along the plane fades within 0.3 s, as the fixture of a curve is stronger than what carries, and
/// comes back as softly; what it gives out of the plane stays.
///
/// Asked nothing, it is the scene. No force depends on what is not finite: of such a finger it lets go. Nothing allocates.
class Guidance final : public Scene {
public:
    /// `scene` must outlive it.
    Guidance(Scene& scene, GuidedLines lines, const PlotFrame& frame, const GuidanceSettings& settings);

    /// Leads it from where it is; `near` is what the curves are to it. Nothing: there is no such place, and it is let go of.
    std::optional<LeadGoal> lead(LeadTo lead, const Point3& finger, const Nearness& near) noexcept;
    void let_go() noexcept { end(LeadEnd::stopped); }
    bool is_leading() const noexcept { return leading_; }
    /// What has ended by itself since the last time that it was asked.
    std::optional<LeadRecord> ended() noexcept;
    /// The last 1024 at most, the oldest first.
    const std::vector<LeadRecord>& records() const noexcept { return records_; }
    const GuidedLines& lines() const noexcept { return lines_; }

    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override;

private:
    bool to_start(bool again, Point finger) noexcept;
    bool to_end(const LinePlace& here, bool again) noexcept;
    bool to_turn(const LinePlace& here, bool again, Point finger) noexcept;
    bool to_other(const LinePlace& here) noexcept;
    LinePlace end_of(std::uint32_t line, bool forward) const noexcept { return {line, forward ? lines_.length(line) : 0}; }
    Point3 led(const Touch& touch, double dt) noexcept;
    bool advance(double way) noexcept;
    void end(LeadEnd how) noexcept;

    Scene& scene_;
    GuidedLines lines_;
    PlotFrame frame_;
    GuidanceSettings settings_;

    bool leading_ = false, carries_ = false;  // else along the curve
    bool follows_ = false;                    // goes on along the curve from where it was carried to
    bool forward_ = true;
    LeadGoal goal_;
    LinePlace on_, stop_;    // where what leads is on its curve, or will be; where it ends
    Point3 ahead_, finger_;  // what leads; the finger, on or above the plane
    double waited_ = 0, rested_ = 0, soft_ = 0, more_ = 0;
    double speed_ = 0;  // mm/s, of what leads
    double gone_ = 0;   // share of the plot's force along the plane that has faded
    std::optional<LinePlace> last_turn_;
    std::optional<std::size_t> last_start_;
    std::size_t ticks_ = 0, begun_ = 0;
    bool told_ = true;
    std::vector<LeadRecord> records_;
};

}  // namespace tactics
