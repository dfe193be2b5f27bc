// SPDX-License-Identifier: Apache-2.0
// A model seen straight from above, as heights.
#pragma once

#include <string>

#include "tactics/readers/model.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

struct ModelBox {
    double low[3] = {0, 0, 0};
    double high[3] = {0, 0, 0};
    double size(int axis) const { return high[axis] - low[axis]; }
};
ModelBox box_of(const Triangles& triangles);

/// x goes to the right, y upwards, z towards the eye. The map is just large enough for the model times `scale`, which stands in
/// its middle; heights are relative to its lowest place, times `scale`, and 0 outside it. A sample is the highest surface above
/// its centre, exactly. Throws Error(failed) at `name` if so many triangles lie over each other that it would take minutes.
HeightMap depth_of(const Triangles& triangles, const ModelBox& box, double scale, double pitch, const std::string& name);

/// As that map would have: they may be many.
double depth_columns(const ModelBox& box, double scale, double pitch);
double depth_rows(const ModelBox& box, double scale, double pitch);

}  // namespace tactics
