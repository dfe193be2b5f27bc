// SPDX-License-Identifier: Apache-2.0
// The plane that a model is drawn in. M. Kurze, CHI 1997, step 5.1: the horizontal plane, the observer's viewing plane or the
// plane of the predominant face.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "tactics/solid/panel.h"
#include "tactics/text/phrase.h"

namespace tactics {

enum class FoldPlane : std::uint8_t {
    automatic,  ///< above, front or face, whichever gives the best rating; above where another is hardly better
    above,
    front,
    side,
    view,  ///< as the file's own viewpoint looks at it; of the ways that faces look in, the nearest
    face,  ///< the way that most of the surface looks in
};
std::string_view name_of(FoldPlane plane);
Phrase seen(FoldPlane plane);  ///< "from above"

/// A plane and what it is called.
struct ChosenPlane {
    FoldPlane plane = FoldPlane::above;
    ViewPlane view = kFromAbove;
};

/// Seen from that direction, as upright as can be. Of the planes above, front and side it has their name, else `otherwise`.
ChosenPlane plane_facing(const Point3& toward, FoldPlane otherwise);

/// Those to be tried for a wish. `viewed_from`: as Model; without one, the front is the viewing plane.
std::vector<ChosenPlane> planes_for(FoldPlane wish, const std::vector<ModelPart>& parts, const Point3& viewed_from);

}  // namespace tactics
