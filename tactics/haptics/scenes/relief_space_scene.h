// SPDX-License-Identifier: Apache-2.0
// A height map under a finger that moves in space: the proxy's force in all three directions.
#pragma once

#include "tactics/haptics/scenes/proxy.h"
#include "tactics/haptics/scenes/pull.h"

namespace tactics {

/// For a fingertip with a radius, the surface must be dilated by it (relief_surface.h), and the finger's position is its lower
/// end.
class ReliefSpaceScene final : public Scene {
public:
    ReliefSpaceScene(const ReliefSurface& surface, const ForceLaw& law) noexcept
        : surface_(surface), law_(law), proxy_(surface) {}  ///< the surface must outlive it
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override { proxy_.lift(); }

private:
    const ReliefSurface& surface_;
    ForceLaw law_;
    Proxy proxy_;
};

}  // namespace tactics
