// SPDX-License-Identifier: Apache-2.0
// Lines that a surface may turn about.
#pragma once

#include <functional>

#include "tactics/solid/solid.h"

namespace tactics {

struct SpaceLine {
    Point3 at;     ///< the place on it that is nearest to the middle of the surface
    Point3 along;  ///< of length 1
};

/// The likeliest first: upright, along the two other directions of the world, and as the normals tell (revolution.h). A line is
/// no candidate if the normals of more than a quarter of the surface miss it.
/// It ends with the first that is taken, which `take` says; false: none was.
bool any_axis(const Solid& solid, const std::function<bool(const SpaceLine&)>& take);

}  // namespace tactics
