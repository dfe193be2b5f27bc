// What the force law follows where the height under the finger jumps.
//
// A motor of 8 N cannot lift a finger 40 mm in the moment in which it crosses an edge: it saturates, and flies past. The paper puts steps into the wall
// (section IV.B.3); the methods here are that one, the plain wall, and a reference that asks for nothing that the motor cannot do.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "tactics/drawing.h"
#include "tactics/haptics/force_law.h"
#include "tactics/haptics/lever.h"

namespace tactics {

/// The height of a surface in mm at a place in mm: a function and what it looks at.
struct HeightSampler {
    const void* surface = nullptr;
    double (*height)(const void* surface, Point at) noexcept = nullptr;
    double operator()(Point at) const noexcept { return height(surface, at); }
};

enum class WallMethod {
    raw,         ///< the height itself
    steps,       ///< the paper's: 1 mm wide, 20 mm high
    rate_limit,  ///< at most 400 mm/s
    governor,    ///< bounded velocity, and an acceleration that the motor has the force for
    look_ahead,  ///< the governor, begun before the edge by the time that the rise takes
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
    FingerSettings finger;       ///< what the governor reckons with
    double step_width = 1;       ///< mm; the paper's
    double step_height = 20;     ///< mm; the paper's
    double rate = 400;           ///< mm/s, of rate_limit
    double slope = 8;            ///< mm up for a mm sideways, of slope
};

class Wall {
public:
    explicit Wall(const WallSettings& settings);

    /// The height to follow now, in mm; call once a tick. The first call begins at the height of the surface. No allocation.
    double reference(HeightSampler surface, Point at, Point velocity, double dt) noexcept;

    double lead() const noexcept { return lead_; }          ///< N to be added: what the reference's own motion takes
    bool couples() const noexcept { return couples_; }      ///< the reference is under way: the lever is held from both sides
    double velocity() const noexcept { return velocity_; }  ///< mm/s, of the reference
    double acceleration() const noexcept { return acceleration_; }

private:
    WallSettings settings_;
    double reference_ = 0, velocity_ = 0, acceleration_ = 0, lead_ = 0;
    bool begun_ = false, couples_ = false;
};

/// The force for a wall's reference: force() or coupling_force() and the lead, clamped to what the lever's motor can.
double wall_force(const WallSettings& settings, const Wall& wall, double reference, double finger, double finger_before, double dt) noexcept;

}  // namespace tactics
