// SPDX-License-Identifier: Apache-2.0
// The position of a scene in the workspace of an arm: the paper's plot wall, "defined by the plane equation Ax + By + Cz + D =
// 0".
#pragma once

#include <memory>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/point3.h"

namespace tactics {

/// A x + B y + C z + D = 0 in the axes of a device (x to the right, y upwards, z towards the person; mm). (A, B, C) points to the
/// side on which the finger is.
struct ScenePlane {
    double a = 0, b = 0, c = 1, d = 0;
};
inline constexpr ScenePlane kUpright{0, 0, 1, 0};  ///< a wall in front of the person
inline constexpr ScenePlane kFlat{0, 1, 0, 0};     ///< a table

/// Size of a device's workspace, mm; its origin is in the middle.
struct Workspace {
    double width = 0, height = 0, depth = 0;
};

/// The axes of a scene (x to the right, y downwards, z towards the finger) as unit vectors in those of a device, and its origin.
struct Mounting {
    Point3 right{1, 0, 0}, down{0, -1, 0}, out{0, 0, 1};
    Point3 origin;

    Point3 to_scene(const Point3& device) const noexcept {
        const Point3 at = device - origin;
        return {dot(at, right), dot(at, down), dot(at, out)};
    }
    Point3 to_device(const Point3& scene) const noexcept { return origin + turned(scene); }
    Point3 turned(const Point3& scene) const noexcept { return scene.x * right + scene.y * down + scene.z * out; }
};

/// The largest field of a scene of that shape (width over height) in a plane, centred on the point of the plane nearest to the
/// middle of the workspace, with `margin` mm to the sides.
struct MountedField {
    Mounting mounting;             ///< its origin is the upper left corner of the field
    double width = 0, height = 0;  ///< mm; 0 if the plane misses the workspace
};
MountedField mount(const ScenePlane& plane, const Workspace& workspace, double aspect, double margin);

/// The device in the axes of the scene.
std::unique_ptr<HapticDevice> mounted(std::unique_ptr<HapticDevice> device, const Mounting& mounting);

}  // namespace tactics
