// SPDX-License-Identifier: Apache-2.0
// The report of `tactics measure`, in words and in JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/information/least_loss.h"
#include "tactics/job/scene_of_file.h"

namespace tactics {

/// A medium and the information that it carries.
struct MeasuredMedium {
    MediumChannel channel;
    Carried carried;
    std::optional<LeastLoss> least;  ///< if requested
};

/// A level of detail: the scene with fewer cells.
struct DetailLevel {
    int columns = 0, rows = 0;
    double bits = 0;    ///< also the information it shares with the whole scene, because it is computed from the scene alone
    double mutual = 0;  ///< bits per cell of the whole that its value gives about the scene's value there (equation 8)
    double error = 0;   ///< mm, root mean square; of lines 0
};

struct MeasureReport {
    std::string file;
    FileScene found;
    std::vector<MeasuredMedium> media;
    std::vector<DetailLevel> levels;
};

std::string text_of(const MeasureReport& report);
std::string json_of(const MeasureReport& report);  ///< one object, one line

}  // namespace tactics
