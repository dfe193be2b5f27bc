// SPDX-License-Identifier: Apache-2.0
// A plot that leads a finger: to the beginning of a curve, along it, to its next turn, across to another curve.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tactics/haptics/scenes/guided_lines.h"
#include "tactics/haptics/scenes/scene.h"

namespace tactics {

/// Places to which a finger can be led.
enum class LeadTo : std::uint8_t {
    start,     ///< to the beginning of the nearest curve; from there, or on a second request, to that of the next
    follow,    ///< along the curve to its end; from there, or on a second request, back
    extremum,  ///< along the curve to its next turn; after the last, the direction reverses
    compare,   ///< straight to the next curve with a value at the same x
};

enum class LeadEnd : std::uint8_t {
    arrived,
    resisted,  ///< the finger stood still for a second against the pull
    left,      ///< it left the path on its own
    stopped,   ///< it was released, or led elsewhere
};

/// A path on which a finger is led.
struct LeadGoal {
    LeadTo lead = LeadTo::start;
    std::uint32_t curve = 0;  ///< index of the curve to which it leads
    std::uint32_t from = 0;   ///< compare: the curve that it leaves
    PlotPoint value;          ///< value at its end; compare: x is that of both
    bool highest = false;     ///< extremum: a maximum
    Point place;              ///< mm, where it ends
};

/// A path that has ended.
struct LeadRecord {
    LeadGoal goal;
    LeadEnd end = LeadEnd::arrived;
    std::size_t from = 0, to = 0;  ///< ticks since the guidance was made
    double off = 0;                ///< mm between the finger and the place at its end
};

struct GuidanceSettings {
    double most_force = 0.8;      ///< N
    double stiffness = 0.5;       ///< N/mm, of the spring between the finger and the leading point
    double damping_ns_per_m = 1;  ///< of the led finger
};

/// For an arm with that greatest force and that law: at most one newton and at most a quarter of the arm's force; no stiffer than
/// the law, and soft enough that the leading point is at least 1.6 mm ahead.
GuidanceSettings guidance_for(double most_force, double stiffness, double damping_ns_per_m);

/// Stands between a plot's scene and the key handler. A point runs ahead of the finger at 40 mm/s, as the simulated hands trace
/// (along the middle of noise too fine for a finger), and pulls it by a spring. It waits for a finger that lags, and releases one
/// that stands still for a second, moves away by more than 5 mm, or has arrived within 0.3 mm of the goal. The leading point
/// starts at the finger, so the force starts at zero; it never exceeds `most_force` in total. If friction holds a finger back
/// before the goal, the pull grows towards that limit. Nothing pulls a finger off the plane z = 0 or into it; a finger above it
/// is also pulled down to it.
///
/// Along a curve, the plot feels as usual. While the finger is carried beside curves (to a beginning, over a gap, to another
/// curve), the plot's force along the plane fades within 0.3 s, because the fixture of a curve is stronger than the pull, and
/// returns as softly; its force out of the plane stays.
///
/// Without a request, it is the plain scene. A finger with a non-finite position is released, so no force depends on it. Nothing
/// allocates.
class Guidance final : public Scene {
public:
    /// `scene` must outlive it.
    Guidance(Scene& scene, GuidedLines lines, const PlotFrame& frame, const GuidanceSettings& settings);

    /// Leads the finger from its position; `near` is the nearest place on the curves. Nothing: there is no such destination, and
    /// the finger is released.
    std::optional<LeadGoal> lead(LeadTo lead, const Point3& finger, const Nearness& near) noexcept;
    void let_go() noexcept { end(LeadEnd::stopped); }
    bool is_leading() const noexcept { return leading_; }
    /// The path that has ended on its own since the last call.
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

    bool leading_ = false, carries_ = false;  // carries: beside curves, else along one
    bool follows_ = false;                    // continues along the curve from the place where it was carried
    bool forward_ = true;
    LeadGoal goal_;
    LinePlace on_, stop_;    // the leading point's present or future place on its curve; the end of the path
    Point3 ahead_, finger_;  // the leading point; the finger, on or above the plane
    double waited_ = 0, rested_ = 0, soft_ = 0, more_ = 0;
    double speed_ = 0;  // mm/s, of the leading point
    double gone_ = 0;   // share of the plot's force along the plane that has faded
    std::optional<LinePlace> last_turn_;
    std::optional<std::size_t> last_start_;
    std::size_t ticks_ = 0, begun_ = 0;
    bool told_ = true;
    std::vector<LeadRecord> records_;
};

}  // namespace tactics
