// SPDX-License-Identifier: Apache-2.0
// The reference of the force law where the height under the finger jumps.
//
// A motor of 8 N cannot lift a finger by 40 mm at the moment it crosses an edge: it saturates and overshoots. The paper puts
// steps into the wall (section IV.B.3); the methods here are that one, the plain wall, and a reference that never exceeds the
// ability of the motor.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "tactics/drawing.h"
#include "tactics/haptics/scenes/force_law.h"
#include "tactics/haptics/scenes/governor.h"
#include "tactics/haptics/simulated/lever.h"

namespace tactics {

/// The height of a surface in mm at a place in mm: a function and its data.
struct HeightSampler {
    const void* surface = nullptr;
    double (*height)(const void* surface, Point at) noexcept = nullptr;
    double operator()(Point at) const noexcept { return height(surface, at); }
};

enum class WallMethod {
    raw,         ///< the height itself
    steps,       ///< the paper's steps: 1 mm wide, 20 mm high
    rate_limit,  ///< at most 400 mm/s
    governor,    ///< bounded velocity, and an acceleration within the motor's force
    look_ahead,  ///< the governor, begun early enough before the edge to finish at it
    slope,       ///< a steep slope that begins at the edge, with the wall left to the eye (section VII)
};

struct NamedWall {
    std::string_view name;
    WallMethod method;
    std::string_view summary;
};
std::span<const NamedWall> wall_methods();
std::optional<WallMethod> wall_method(std::string_view name);

struct WallSettings {
    WallMethod method = WallMethod::look_ahead;
    ForceLaw law;
    LeverSettings lever;
    FingerSettings finger =
        kFingers[0].finger;   ///< the finger assumed by the governor; if unknown, the softest: a stiffer finger is then lifted a
                              ///< little late, whereas a finger softer than assumed overshoots the top by 4 mm
    double step_width = 1;    ///< mm; the paper's
    double step_height = 20;  ///< mm; the paper's
    double rate = 400;        ///< mm/s, of rate_limit
    double slope = 8;         ///< mm up per mm sideways, for slope
    double late = 0.4;        ///< mm by which look_ahead lets an edge be felt late; a later beginning is in vain less often
    double most_bump = 0.9;   ///< mm that look_ahead may rise above the surface before a wall at which the hand stops; it begins
                              ///< later if necessary
    double nearest_stop = 1;  ///< mm before a wall: a hand that stops closer may feel a higher bump. For a fingertip, which
                              ///< distinguishes places 1 mm apart at best, it is at the wall
};

/// How far below its reference a lever with a finger rests, mm: weight and preload on the spring of the force law.
double hangs(const WallSettings& settings);

class Wall {
public:
    explicit Wall(const WallSettings& settings);

    /// The height to follow now, mm; call it once per tick. The first call begins at the height of the surface. `doubt`: possible
    /// error of the velocity, mm/s. No allocation.
    double reference(HeightSampler surface, Point at, Point velocity, double dt, double doubt = 0) noexcept;

    double lead() const noexcept { return governs_ ? governor_.lead() : 0; }  ///< N to add for the reference's own motion
    /// The reference is moving: the lever is coupled to it from both sides.
    bool couples() const noexcept { return governs_ && governor_.under_way(); }
    double velocity() const noexcept { return velocity_; }  ///< mm/s, of a governed reference
    const Governor& governor() const noexcept { return governor_; }

private:
    struct Ahead {
        Point edge;         ///< position of half the rise
        double height = 0;  ///< of its top
        double to_top = 0;  ///< mm from the edge
    };
    struct Past {
        double height = 0, velocity = 0;
    };
    Wall(const WallSettings& settings, WallMethod method);
    double stepped(double height, double moved) noexcept;
    double foreseen(HeightSampler surface, double here, Point at, Point velocity, double dt, double doubt) noexcept;
    std::optional<Ahead> look(HeightSampler surface, Point at, Point velocity, double here) const noexcept;
    bool still_comes(HeightSampler surface, double here, Point at, Point velocity, double left) const noexcept;
    double time_to_half(double rise) const noexcept;

    double time_to_rise(double rise) const;
    double time_to_change_its_mind() const;
    void remember() noexcept;

    static constexpr std::size_t kRises = 13;
    static constexpr std::size_t kPast = 64;

    WallSettings settings_;
    Governor governor_;
    bool governs_ = false, begun_ = false;
    Point before_;
    double target_ = 0, reference_ = 0, velocity_ = 0;
    double since_step_ = 0;  ///< mm moved
    double stepped_ = 0;     ///< mm risen or fallen since
    double fastest_ = 0;     ///< recent maximum, mm/s
    bool slowing_ = false;
    std::optional<Ahead> ahead_;               ///< the wall for which the rise has begun
    std::array<double, kRises> half_times_{};  ///< s until half of a rise of 0, 5, 10 ... mm is done
    double may_err_ = 0;                       ///< s that a rise may continue before it must be confirmed
    std::array<Past, kPast> past_{};           ///< of the governor, the last `now_`
    std::size_t now_ = 0;
};

/// The force for a wall's reference: force() or coupling_force(), plus the lead, clamped to the force of the lever's motor.
double wall_force(const WallSettings& settings, const Wall& wall, double reference, double finger, double finger_before,
                  double dt) noexcept;

}  // namespace tactics
