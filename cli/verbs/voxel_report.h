// SPDX-License-Identifier: Apache-2.0
// What `tactics measure` tells of voxels, in words and in JSON.
#pragma once

#include <string>
#include <vector>

#include "tactics/information/voxels.h"
#include "tactics/readers/nrrd.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct VoxelReport {
    std::string file;
    int columns = 0, rows = 0, slices = 0;
    VoxelLevels levels;
    MeasuredVoxels measured;
    std::vector<Phrase> notes;
};

/// Throws Error(failed): all voxels are the same.
VoxelReport voxel_report(const std::string& file, Voxels voxels, bool with_details);

std::string text_of(const VoxelReport& report);
std::string json_of(const VoxelReport& report);  ///< one object, one line

}  // namespace tactics
