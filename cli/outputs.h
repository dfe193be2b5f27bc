// SPDX-License-Identifier: Apache-2.0
// Which files come out of which pictures: worked out, and refused where something would be lost, before any work starts.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/disk.h"
#include "tactics/job/item.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// `outs` are the values of -o: FILE, FORMAT:FILE, FOLDER/, FORMAT:FOLDER/; `to` the format names for folders.
/// A machine may be named by its model; `notes` are told what drives it. Of several `pages` each is an item of its own, whose
/// names end in "-page3". Throws Error(usage): no or unknown format, a file for many pictures, two outputs of one name, an output
/// over an input.
std::vector<Item> plan_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outs,
                               const std::vector<std::string>& to, const Disk& disk, const std::vector<int>& pages = {0},
                               std::vector<Phrase>* notes = nullptr);

}  // namespace tactics
