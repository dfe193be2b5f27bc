// SPDX-License-Identifier: Apache-2.0
// The recipe from the command line: --recipe, --filter, --set and --detail.
#pragma once

#include "cli/command.h"
#include "tactics/job/disk.h"
#include "tactics/job/recipe_wish.h"

namespace tactics {

/// Throws Error(usage), Error(failed) for a file that cannot be read.
RecipeWish read_chain(const Given& given, const Disk& disk);

}  // namespace tactics
