// SPDX-License-Identifier: Apache-2.0
// How much information numbers or forces on voxels hold (section 3.1 of K. Moustakas, "Handling haptics as a stand-alone medium",
// WSCG 2013), whole and at fewer voxels, between which the field is trilinear.
#pragma once

#include <string_view>
#include <vector>

#include "tactics/information/grid.h"
#include "tactics/information/measures.h"

namespace tactics {

/// In what whole numbers a component is counted.
struct VoxelLevels {
    int components = 1;  ///< 1: x of the forces alone; 3
    double low = 0, high = 255;
    int levels = 256;  ///< from `low` to `high`
};

struct VoxelDetail {
    int columns = 0, rows = 0, slices = 0;
    double bits = 0;   ///< of its shortest code, all components; no more than with more voxels
    double error = 0;  ///< root mean square, when the rest is interpolated from these
};

struct MeasuredVoxels {
    std::vector<Measures> along;  ///< of each component
    double raw = 0, low = 0, bits = 0, high = 0;
    std::vector<VoxelDetail> details;  ///< all, then half as many each way, a quarter, and so on, down to two
};

/// Throws Error(failed): all voxels are the same, so there is nothing to measure. `name` is the file's, for messages.
MeasuredVoxels measured(const ForceField& field, const VoxelLevels& levels, bool with_details, std::string_view name);

}  // namespace tactics
