// SPDX-License-Identifier: Apache-2.0
// Scattered points: a sphere surrounds the finger, and every point within it pushes the finger away ("Haptic Representation of
// Scientific Data for Visually Impaired or Blind Persons", section 3).
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/haptics/scenes/scene.h"

namespace tactics {

struct PointsFeel {
    double radius = 3;            ///< mm, of the sphere
    double stiffness = 1;         ///< N/mm, of a single point
    double damping_ns_per_m = 0;  ///< along the push, full from half of the depth on
};

/// Each point pushes with a stiffness times its depth in the sphere, and the forces are summed. A single point has the full
/// stiffness; points within a radius of each other share it, so that a cloud is about as stiff as one point, which the device can
/// sustain. The shares are constant, so the force has a potential. The cost depends only on the points near the finger.
class PointsScene final : public Scene {
public:
    /// mm. Points in the same cube of `merged` mm are merged (the larger of the device's resolution and a sixth of the radius,
    /// which no finger can distinguish from one place); size() gives the number left.
    PointsScene(const std::vector<Point3>& points, const PointsFeel& feel, double merged);
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override {}
    std::size_t size() const noexcept { return points_.size(); }

private:
    PointsFeel feel_;
    Point corner_;
    double cell_ = 1;  // mm, at least the radius
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<std::uint32_t> starts_;
    struct Spike {
        Point3 at;
        double share;  // share of the stiffness
    };
    template <typename Visit>
    void each_near(const Point3& place, Visit visit) const noexcept;

    std::vector<Spike> points_;  // sorted by cells
};

}  // namespace tactics
