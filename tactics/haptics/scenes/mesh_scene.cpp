// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/mesh_scene.h"

#include <utility>

#include "tactics/error.h"
#include "tactics/haptics/scenes/enough_mesh.h"

namespace tactics {

MeshScene::MeshScene(std::shared_ptr<const MeshTree> tree, const MeshFeel& feel)
    : tree_(std::move(tree)),
      feel_(feel),
      normals_(feel.smooth ? corner_normals(tree_->facets()) : std::vector<Point3>()),
      shadow_(*tree_, feel.radius),
      second_(*tree_, feel.radius) {}

// The finger is taken to be where it would press on a plane through its shadow whose normal is that of the corners around, each
// by its share; the shadow of that is what pulls. Where facets meet in a hollow they are felt as they are.
Point3 MeshScene::shaded(const Point3& finger, const Point3& outside) noexcept {
    const ShadowPoint::Touching* held = nullptr;
    for (const auto& touching : shadow_.touching()) {
        if (touching.pressed <= 0) continue;
        if (held != nullptr) return outside;
        held = &touching;
    }
    if (held == nullptr) return outside;
    const FacetCorners f = tree_->corners(held->facet);
    const Point3 over = cross(f.b - f.a, f.c - f.a), &at = held->contact.place;
    const double all = dot(over, over);
    const double share_a = dot(cross(f.b - at, f.c - at), over) / all, share_b = dot(cross(f.c - at, f.a - at), over) / all;
    const auto& corner = tree_->facets().facets[held->facet];
    Point3 normal = share_a * normals_[corner[0]] + share_b * normals_[corner[1]] + (1 - share_a - share_b) * normals_[corner[2]];
    const double length = length_of(normal);
    if (!(length > 1e-9)) return outside;
    normal = (dot(normal, held->contact.normal) < 0 ? -1 / length : 1 / length) * normal;
    const double pressed = dot(outside - finger, normal);
    if (pressed <= 0) return outside;
    second_ = shadow_;
    return second_.follow(finger + pressed * normal);
}

Felt MeshScene::feel(const Touch& touch, double) noexcept {
    Felt felt;
    if (!is_finite(touch.finger)) return felt;
    const Point3 outside = shadow_.follow(touch.finger);
    felt.surface = outside.z - feel_.radius;
    felt.reference = outside.z;
    if (!shadow_.arrived()) return felt;
    felt.force = pull(feel_.law, feel_.smooth ? shaded(touch.finger, outside) : outside, touch);
    return felt;
}

std::unique_ptr<Scene> scene_of(const Mesh& mesh, const MeshFeel& feel, const std::string& name, std::vector<Phrase>& notes) {
    MeshFacets facets = facets_of(mesh);
    if (facets.facets.empty())
        throw Error(Fault::failed, name,
                    phrase("has no triangle with an area, so nothing of it can be felt; save the model again"));
    if (feel.closed)
        for (Phrase& note : notes_on(facets)) notes.push_back(std::move(note));
    if (feel.resolution > 0) {
        EnoughMesh enough = enough_facets(std::move(facets), feel.resolution);
        facets = std::move(enough.facets);
        if (facets.facets.size() < enough.of_all) notes.push_back(std::move(enough.words));
    }
    return std::make_unique<MeshScene>(std::make_shared<MeshTree>(std::move(facets)), feel);
}

}  // namespace tactics
