// SPDX-License-Identifier: Apache-2.0
// Plans the output files of each picture before any work starts, and refuses plans that would lose a file.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/disk.h"
#include "tactics/job/item.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// `outs` are the values of -o: FILE, FORMAT:FILE, FOLDER/, FORMAT:FOLDER/; `to` the format names for folders.
/// A machine may be named by its model; `notes` then names its driver. Each of several `pages` is a separate item, whose names
/// end in "-page3". Throws Error(usage) for a missing or unknown format, one file for many pictures, two outputs with one name,
/// or an output that would overwrite an input.
std::vector<Item> plan_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outs,
                               const std::vector<std::string>& to, const Disk& disk, const std::vector<int>& pages = {0},
                               std::vector<Phrase>* notes = nullptr);

}  // namespace tactics
