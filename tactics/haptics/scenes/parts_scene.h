// SPDX-License-Identifier: Apache-2.0
// Several scenes in one place, whose forces are summed, within a box that activates them.
#pragma once

#include <memory>
#include <vector>

#include "tactics/haptics/scenes/scene.h"

namespace tactics {

/// The region where a scene can be felt, mm. A wall without end has an infinite side.
struct Box3 {
    Point3 low, high;
    bool holds(const Point3& p) const noexcept {
        return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z && p.z <= high.z;
    }
};

/// "Collision detection for the individual graph items is not computed until the IP is within the bounding box" (Fritz and
/// Barner).
class PartsScene final : public Scene {
public:
    PartsScene(std::vector<std::unique_ptr<Scene>> parts, const Box3& box) : parts_(std::move(parts)), box_(box) {}
    Felt feel(const Touch& touch, double dt) noexcept override {
        Felt felt;
        if (!box_.holds(touch.finger)) return felt;
        for (const auto& part : parts_) {
            const Felt one = part->feel(touch, dt);
            felt.force = felt.force + one.force;
            felt.surface += one.surface;
            felt.reference += one.reference;
        }
        return felt;
    }
    void begin_again() noexcept override {
        for (const auto& part : parts_) part->begin_again();
    }

private:
    std::vector<std::unique_ptr<Scene>> parts_;
    Box3 box_;
};

}  // namespace tactics
