// SPDX-License-Identifier: Apache-2.0
// The files that pages go to, and what must not be lost to them.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "tactics/job/disk.h"
#include "tactics/job/item.h"

namespace tactics {

/// Where page `number`, from 1, of an output goes whose format holds one page a file: the first to its path, others beside
/// it, "page-2.png".
std::string path_of_page(const Output& output, std::size_t number);

/// What further pages must not be written to: all pictures and outputs, in words of its own. Folders must be there.
std::set<std::string> taken_by(std::span<const Item> items, const Disk& disk);

/// Throws Error(usage) if that many files of an output cannot be told apart, or one of them would be written over what is taken.
/// How many they are is known only when the pages are made.
void check_page_files(const Output& output, std::size_t files, const std::set<std::string>& taken, const Disk& disk);

/// A file that is named like the page behind the last, and is no page of this picture: of an earlier run, or a person's own.
/// Empty: there is none.
std::string left_over_behind(const Output& output, std::size_t files, const std::set<std::string>& taken, const Disk& disk);

}  // namespace tactics
