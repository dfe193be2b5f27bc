// SPDX-License-Identifier: Apache-2.0
// A relief under a lever that only moves up and down: a wall's reference, the force that follows it, and a vibration at edges.
#pragma once

#include "tactics/haptics/scenes/relief_surface.h"
#include "tactics/haptics/scenes/scene.h"
#include "tactics/haptics/scenes/transient.h"
#include "tactics/haptics/scenes/wall.h"

namespace tactics {

struct ReliefFeel {
    WallSettings wall;  ///< including the force law and the lever
    TransientSettings edges;
};

class ReliefScene final : public Scene {
public:
    ReliefScene(const ReliefSurface& surface, const ReliefFeel& feel);  ///< the surface must outlive it
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override { touched_ = false; }

private:
    const ReliefSurface& surface_;
    WallSettings settings_;
    Wall wall_;
    EdgeTransient edges_;
    bool touched_ = false;
    double finger_before_ = 0;
};

}  // namespace tactics
