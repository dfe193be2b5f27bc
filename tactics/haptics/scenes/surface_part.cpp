// SPDX-License-Identifier: Apache-2.0
// The surface of a plot, as facets over the field.
#include <utility>

#include "tactics/haptics/scenes/mesh_scene.h"
#include "tactics/haptics/scenes/plot_part.h"
#include "tactics/haptics/scenes/surface_mesh.h"

namespace tactics {

namespace {

// Meshes have y away from the person, and a field downwards from its top.
class UpsideDown final : public Scene {
public:
    UpsideDown(std::unique_ptr<Scene> scene, double height) : scene_(std::move(scene)), height_(height) {}
    Felt feel(const Touch& touch, double dt) noexcept override {
        Touch turned = touch;
        turned.finger.y = height_ - touch.finger.y;
        turned.velocity.y = -touch.velocity.y;
        Felt felt = scene_->feel(turned, dt);
        felt.force.y = -felt.force.y;
        return felt;
    }
    void begin_again() noexcept override { scene_->begin_again(); }

private:
    std::unique_ptr<Scene> scene_;
    double height_;
};

std::unique_ptr<Scene> make_surface_part(const PlotFeel& feel, std::vector<Phrase>& told) {
    if (feel.plot.surfaces.empty() || !(feel.frame.depth > 0)) return nullptr;
    const PlotSurface& surface = feel.plot.surfaces.front();
    if (feel.plot.surfaces.size() > 1)
        told.push_back(phrase("{0} surfaces are there, and the first is felt", std::to_string(feel.plot.surfaces.size())));
    const Mesh mesh = mesh_of(surface, {feel.frame.width, feel.frame.height, feel.frame.depth});
    const MeshFeel felt{.law = feel.law, .resolution = feel.resolution, .closed = false};
    return std::make_unique<UpsideDown>(scene_of(mesh, felt, "the surface", told), feel.frame.height);
}

}  // namespace

extern const PlotPart surface_part;
const PlotPart surface_part{"surface", "heights over x and y, as facets", make_surface_part};

}  // namespace tactics
