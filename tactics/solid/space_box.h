// SPDX-License-Identifier: Apache-2.0
// Upright boxes in space.
#pragma once

#include "tactics/solid/part.h"

namespace tactics {

/// Share of an extent by which parts of a model may be apart where they are meant to meet.
inline constexpr double kLoose = 0.02;

struct SpaceBox {
    Point3 low, high;
};
SpaceBox space_of(const ModelPart& part);
SpaceBox space_of(const Patch& patch);
SpaceBox grown(const SpaceBox& box, double margin);
/// mm along the axis where they are farthest apart; 0: they meet.
double apart(const SpaceBox& a, const SpaceBox& b);

}  // namespace tactics
