// SPDX-License-Identifier: Apache-2.0
// What `tactics measure` tells, in words and in JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/information/least_loss.h"
#include "tactics/job/scene_of_file.h"

namespace tactics {

/// A medium and what comes through it.
struct MeasuredMedium {
    MediumChannel channel;
    Carried carried;
    std::optional<LeastLoss> least;  ///< if it was asked for
};

/// A level of detail: the scene with fewer cells.
struct DetailLevel {
    int columns = 0, rows = 0;
    double bits = 0;    ///< which are also what it and the whole scene have in common, as it is made of that alone
    double mutual = 0;  ///< bits a cell of the whole that its value tells of the scene's there (equation 8)
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
