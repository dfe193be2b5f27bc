// SPDX-License-Identifier: Apache-2.0
// The files that pages go to, and the files that they must not overwrite.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "tactics/job/disk.h"
#include "tactics/job/item.h"

namespace tactics {

/// The file of page `number`, from 1, for a format that holds one page per file: the first goes to the path of the output, others
/// beside it, "page-2.png".
std::string path_of_page(const Output& output, std::size_t number);

/// Files to which further pages must not be written: all pictures and outputs, as unique names. Folders must exist.
std::set<std::string> taken_by(std::span<const Item> items, const Disk& disk);

/// Throws Error(usage) if that many files of an output would not have different names, or if one would overwrite a taken file.
/// The number is known only after the pages are made.
void check_page_files(const Output& output, std::size_t files, const std::set<std::string>& taken, const Disk& disk);

/// An existing file that is named like the page after the last: from an earlier run, or a person's own. Empty: none.
std::string left_over_behind(const Output& output, std::size_t files, const std::set<std::string>& taken, const Disk& disk);

}  // namespace tactics
