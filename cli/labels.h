// SPDX-License-Identifier: Apache-2.0
// Names of things, from the options --label and --labels.
#pragma once

#include <vector>

#include "cli/command.h"
#include "tactics/job/disk.h"
#include "tactics/job/item.h"

namespace tactics {

/// The labels and subjects of each picture: those of --label, then those of the file --labels or, if that is a folder, of the
/// file in it named after the picture, "map.labels" for "pictures/map.png", if it exists. Throws Error.
void plan_labels(std::vector<Item>& items, const Given& given, const Disk& disk);

}  // namespace tactics
