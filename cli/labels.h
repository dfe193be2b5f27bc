// SPDX-License-Identifier: Apache-2.0
// Names of things, as options say them: --label and --labels.
#pragma once

#include <vector>

#include "cli/command.h"
#include "tactics/job/disk.h"
#include "tactics/job/item.h"

namespace tactics {

/// The labels of each picture and what matters in it: those of --label, then those of the file --labels or, if that is a folder,
/// of the file in it that is named like the picture, "map.labels" for "pictures/map.png"; there may be none. Throws Error.
void plan_labels(std::vector<Item>& items, const Given& given, const Disk& disk);

}  // namespace tactics
