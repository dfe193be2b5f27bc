// SPDX-License-Identifier: Apache-2.0
// Scattered points: a sphere is placed round the finger, and every point within it pushes the finger away ("Haptic Representation
// of Scientific Data for Visually Impaired or Blind Persons", section 3).
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/haptics/scenes/scene.h"

namespace tactics {

struct PointsFeel {
    double radius = 3;            ///< mm, of the sphere
    double stiffness = 1;         ///< N/mm, of a point alone
    double damping_ns_per_m = 0;  ///< along the push, whole from half of the depth on
};

/// Each point pushes with a stiffness times the depth of the sphere over it, and the forces are summed. A point alone has the
/// whole stiffness; one with others within a radius of it has its share of that, so that a cloud is about as stiff as one point,
/// which is what the device bears. The shares do not change while a finger feels: the force keeps a potential. The cost is that
/// of the points near the finger.
class PointsScene final : public Scene {
public:
    /// mm. Points in the same cube of `merged` mm (a device's resolution, or a sixth of the radius, which no finger tells from
    /// one place, if that is more) are one; how many are left is told by size().
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
        double share;  // of the stiffness
    };
    template <typename Visit>
    void each_near(const Point3& place, Visit visit) const noexcept;

    std::vector<Spike> points_;  // by cells
};

}  // namespace tactics
