// SPDX-License-Identifier: Apache-2.0
// A mesh under a finger that moves in space.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tactics/haptics/scenes/pull.h"
#include "tactics/haptics/scenes/shadow_point.h"

namespace tactics {

struct MeshFeel {
    ForceLaw law;         ///< its sign plays no part
    double radius = 0;    ///< mm, of the finger: its position is that of its middle; 0: a point
    bool smooth = false;  ///< facets feel round: force shading as D. C. Ruspini, K. Kolarov and O. Khatib have it (SIGGRAPH 1997)
    double resolution = 0;  ///< mm that the device tells apart: facets that it cannot are left out (enough_mesh.h); 0: none are
    bool closed = true;     ///< it should be a solid: where it is open is told
};

/// The force along the way from the finger to its shadow point. Nothing is felt until the finger has once been outside of what it
/// was set down in.
class MeshScene final : public Scene {
public:
    MeshScene(std::shared_ptr<const MeshTree> tree, const MeshFeel& feel);
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override { shadow_.lift(); }
    const ShadowPoint& shadow() const noexcept { return shadow_; }

private:
    Point3 shaded(const Point3& finger, const Point3& outside) noexcept;

    std::shared_ptr<const MeshTree> tree_;
    MeshFeel feel_;
    std::vector<Point3> normals_;  // of corners; none unless it is smooth
    ShadowPoint shadow_, second_;
};

/// What `play` asks for. `notes` is told what of the mesh is left out or open. Throws Error(failed) at `name` where nothing of it
/// can be felt.
std::unique_ptr<Scene> scene_of(const Mesh& mesh, const MeshFeel& feel, const std::string& name, std::vector<Phrase>& notes);

}  // namespace tactics
